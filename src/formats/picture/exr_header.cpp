// Headers of EXR files, as in "OpenEXR File Layout" (openexr.com).

#include "formats/picture/exr_header.h"

#include "formats/picture/codecs.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace glint::formats {

namespace {

using Bytes = std::span<const std::byte>;

/// Types whose values all have the same number of bytes.
struct FixedType {
    std::string_view name;
    std::size_t bytes;
};
constexpr FixedType fixed_types[] = {{"box2f", 16},
                                     {"box2i", 16},
                                     {"chromaticities", 32},
                                     {"compression", 1},
                                     {"deepImageState", 1},
                                     {"double", 8},
                                     {"envmap", 1},
                                     {"float", 4},
                                     {"int", 4},
                                     {"keycode", 28},
                                     {"lineOrder", 1},
                                     {"m33d", 72},
                                     {"m33f", 36},
                                     {"m44d", 128},
                                     {"m44f", 64},
                                     {"rational", 8},
                                     {"tiledesc", 9},
                                     {"timecode", 8},
                                     {"v2d", 16},
                                     {"v2f", 8},
                                     {"v2i", 8},
                                     {"v3d", 24},
                                     {"v3f", 12},
                                     {"v3i", 12}};

/// Rows that are compressed together: by none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
constexpr int rows_of_blocks[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

std::uint32_t integer_at(Bytes bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

/// The bytes before the next 0, which are then skipped with it; none if there is no 0.
std::optional<std::string_view> take_text(Bytes& bytes) {
    const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t length = all.find('\0');
    if (length == std::string_view::npos) return std::nullopt;
    bytes = bytes.subspan(length + 1);
    return all.substr(0, length);
}

/// Bytes of a pixel in these channels: each has a name, its type (1: half, else 4 bytes), a byte and three
/// unused ones, and its sampling in x and y; an empty name ends the list. None if the list is damaged.
std::optional<double> bytes_of_channels(Bytes list) {
    constexpr std::size_t after_name = 16;
    double sum = 0;
    while (const auto name = take_text(list)) {
        if (name->empty()) return list.empty() ? std::optional(sum) : std::nullopt;
        if (list.size() < after_name) break;
        sum += integer_at(list, 0) == 1 ? 2 : 4;
        list = list.subspan(after_name);
    }
    return std::nullopt;
}

bool is_list_of_strings(Bytes list) {
    while (list.size() >= 4) {
        const std::size_t length = integer_at(list, 0);
        if (length > list.size() - 4) return false;
        list = list.subspan(4 + length);
    }
    return list.empty();
}

/// Does the value take exactly the bytes that its type gives it? Types that are not named here are read by
/// the length of the attribute.
bool is_whole(std::string_view type, Bytes value) {
    const auto* fixed = std::ranges::find(fixed_types, type, &FixedType::name);
    if (fixed != std::end(fixed_types)) return value.size() == fixed->bytes;
    if (type == "chlist") return bytes_of_channels(value).has_value();
    if (type == "floatvector") return value.size() % 4 == 0;
    if (type == "idmanifest") return value.size() >= 4;
    if (type == "preview")
        return value.size() >= 8 && value.size() % 4 == 0 &&
               std::uint64_t{integer_at(value, 0)} * integer_at(value, 4) == value.size() / 4 - 2;
    if (type == "stringvector") return is_list_of_strings(value);
    return true;
}

/// Magic, version and flags, then attributes: name 0 type 0 length value …, then 0.
class ExrHeaderReader {
  public:
    ExrHeaderReader(Bytes bytes, const std::string& name) : size_(bytes.size()), left_(bytes), name_(name) {}

    ExrHeader run() {
        check_kind();
        while (read_attribute()) {
        }
        if (!has_window_) refuse("the header has no data window");
        header_.bytes = size_ - left_.size();
        return header_;
    }

  private:
    void check_kind() {
        constexpr std::uint32_t tiled = 0x200;
        constexpr std::uint32_t deep = 0x800;
        constexpr std::uint32_t parts = 0x1000;
        take(4);
        start_ = 4;
        const std::uint32_t flags = integer_at(take(4), 0);
        if ((flags & 255U) != 2) refuse("an EXR of an unknown version", "version 2 is known");
        if ((flags & (tiled | deep | parts)) != 0)
            refuse("an EXR in tiles, in several parts or with deep pixels",
                   "save it as a flat picture in one part, by scan lines");
    }

    bool read_attribute() {
        start_ = size_ - left_.size();
        const std::string_view key = text();
        if (key.empty()) return false;
        const std::string_view type = text();
        const std::size_t length = integer_at(take(4), 0);
        if (length > left_.size()) refuse("an attribute is longer than the file");
        const Bytes value = take(length);
        if (!is_whole(type, value))
            refuse("the attribute '" + std::string(key) + "' is no whole " + std::string(type));
        store(key, type, value);
        return true;
    }

    void store(std::string_view key, std::string_view type, Bytes value) {
        if (key == "dataWindow" && type == "box2i") {
            const auto side = [&](std::size_t i) {
                return static_cast<std::int32_t>(integer_at(value, 4 * i));
            };
            header_.window = {side(0), side(1), side(2), side(3)};
            has_window_ = true;
        }
        if (type == "chlist") header_.pixel_bytes += *bytes_of_channels(value);
        const auto number = type == "compression" ? std::to_integer<std::size_t>(value[0]) : SIZE_MAX;
        if (key == "compression" && number < std::size(rows_of_blocks))
            header_.rows_of_a_block = rows_of_blocks[number];
    }

    Bytes take(std::size_t count) {
        if (left_.size() < count) refuse("the file ends within its header");
        const Bytes taken = left_.first(count);
        left_ = left_.subspan(count);
        return taken;
    }

    std::string_view text() {
        constexpr std::size_t longest = 255;
        const auto found = take_text(left_);
        if (!found) refuse("the file ends within its header");
        if (found->size() > longest) refuse("a name in the header is longer than 255 bytes");
        return *found;
    }

    [[noreturn]] void refuse(const std::string& message, const std::string& hint = cut_hint) const {
        refuse_picture(name_, message, hint, start_);
    }

    std::size_t size_;
    Bytes left_;
    const std::string& name_;
    std::size_t start_ = 0; ///< of the attribute
    bool has_window_ = false;
    ExrHeader header_;
};

} // namespace

ExrHeader read_exr_header(std::span<const std::byte> bytes, const std::string& name) {
    return ExrHeaderReader(bytes, name).run();
}

// A table of 8 bytes for each block follows the header: where in the file it stands.
bool has_all_blocks(std::span<const std::byte> file) {
    const ExrHeader header = read_exr_header(file, "");
    const auto rows = static_cast<std::size_t>(header.window.height());
    const auto block = static_cast<std::size_t>(header.rows_of_a_block);
    for (std::size_t i = 0; i < (rows + block - 1) / block; ++i)
        if (integer_at(file, header.bytes + 8 * i) == 0 && integer_at(file, header.bytes + 8 * i + 4) == 0)
            return false;
    return true;
}

} // namespace glint::formats
