#include "picture_support.h"

namespace glint::test::png {

namespace {

/// CRC-32 as the PNG specification defines it, bit by bit.
std::uint32_t crc(const Bytes& bytes) {
    std::uint32_t rest = 0xffffffffU;
    for (const std::byte byte : bytes) {
        rest ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1U) ^ ((rest & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~rest;
}

std::uint32_t adler(const Bytes& bytes) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::byte byte : bytes) {
        a = (a + std::to_integer<std::uint32_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16U | a;
}

std::byte byte_of(std::size_t value) { return static_cast<std::byte>(value & 255U); }

} // namespace

Bytes chunk(std::string_view type, const Bytes& data) {
    Bytes checked = bytes_of(type);
    append(checked, data);
    Bytes result = big_endian(static_cast<std::uint32_t>(data.size()));
    append(result, checked);
    append(result, big_endian(crc(checked)));
    return result;
}

Bytes head(std::uint32_t width, std::uint32_t height, int depth, int color_type, int interlaced) {
    Bytes fields = big_endian(width);
    append(fields, big_endian(height));
    for (const int field : {depth, color_type, 0, 0, interlaced})
        fields.push_back(static_cast<std::byte>(field));
    Bytes result = bytes_of("\x89PNG\r\n\x1a\n");
    append(result, chunk("IHDR", fields));
    return result;
}

Bytes data(const std::vector<int>& rows) {
    Bytes raw;
    for (const int value : rows) raw.push_back(static_cast<std::byte>(value));
    // A zlib stream of one stored block: length and its complement, low byte first.
    Bytes stream = bytes_of("\x78\x01\x01");
    const std::size_t size = raw.size();
    for (const std::size_t field : {size, size >> 8U, ~size, ~size >> 8U}) stream.push_back(byte_of(field));
    append(stream, raw);
    append(stream, big_endian(adler(raw)));
    return chunk("IDAT", stream);
}

Bytes file(const Bytes& head, const Bytes& others, const std::vector<int>& rows) {
    Bytes result = head;
    append(result, others);
    append(result, data(rows));
    append(result, chunk("IEND", {}));
    return result;
}

std::vector<std::pair<std::string, std::string>> chunks(const Bytes& file) {
    std::vector<std::pair<std::string, std::string>> result;
    const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
    constexpr std::size_t signature = 8;
    for (std::size_t at = signature; at + 12 <= text.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(text[at + i]);
        result.emplace_back(text.substr(at + 4, 4), text.substr(at + 8, length));
        at += length + 12;
    }
    return result;
}

} // namespace glint::test::png
