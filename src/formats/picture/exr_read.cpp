// Reading EXR files with OpenEXR.

#include "formats/picture/codecs.h"
#include "formats/picture/exr_twice.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string_view>

namespace glint::formats {

namespace {

/// OpenEXR's input stream over memory; end of file must be reported by an exception.
class MemoryInput : public Imf::IStream {
  public:
    explicit MemoryInput(std::span<const std::byte> bytes) : Imf::IStream("memory"), bytes_(bytes) {}

    bool read(char* out, int size) override {
        const auto count = static_cast<std::uint64_t>(size);
        if (size < 0 || at_ > bytes_.size() || count > bytes_.size() - at_)
            throw std::runtime_error("the data end early");
        std::memcpy(out, bytes_.data() + at_, count);
        at_ += count;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

  private:
    std::span<const std::byte> bytes_;
    std::uint64_t at_ = 0;
};

struct Window {
    std::int32_t min_x = 0;
    std::int32_t min_y = 0;
    std::int32_t max_x = -1;
    std::int32_t max_y = -1;
    std::int64_t width() const { return std::int64_t{max_x} - min_x + 1; }
    std::int64_t height() const { return std::int64_t{max_y} - min_y + 1; }
};

/// Checks the structure of the header before OpenEXR parses it, since OpenEXR allocates memory for any
/// lengths and sizes that a header claims. Structure: magic, version and flags, then name 0 type 0 length
/// value …, then 0.
class HeaderCheck {
  public:
    HeaderCheck(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Window run() {
        check_kind();
        Window window;
        bool found = false;
        for (;;) {
            const std::size_t start = at_;
            const std::string_view key = text();
            if (key.empty()) break;
            text();
            const std::int32_t length = integer();
            if (length < 0 || static_cast<std::size_t>(length) > bytes_.size() - at_)
                refuse("an attribute is longer than the file", cut_hint, start);
            if (key == "dataWindow" && length == 16) {
                window = {integer_at(at_), integer_at(at_ + 4), integer_at(at_ + 8), integer_at(at_ + 12)};
                found = true;
            }
            at_ += static_cast<std::size_t>(length);
        }
        if (!found) refuse("the header has no data window", cut_hint, at_);
        return window;
    }

  private:
    void check_kind() {
        constexpr std::uint32_t tiled = 0x200;
        constexpr std::uint32_t deep = 0x800;
        constexpr std::uint32_t parts = 0x1000;
        at_ = 4;
        const auto flags = static_cast<std::uint32_t>(integer());
        if ((flags & 255U) != 2) refuse("an EXR of an unknown version", "version 2 is known", 4);
        if ((flags & (tiled | deep | parts)) != 0)
            refuse("an EXR in tiles, in several parts or with deep pixels",
                   "save it as a flat picture in one part, by scan lines", 4);
    }

    std::string_view text() {
        const std::size_t start = at_;
        while (at_ < bytes_.size() && bytes_[at_] != std::byte{0}) ++at_;
        if (at_ == bytes_.size()) refuse("the file ends within its header", cut_hint, start);
        return {reinterpret_cast<const char*>(bytes_.data()) + start, at_++ - start};
    }

    std::int32_t integer() {
        if (bytes_.size() - at_ < 4) refuse("the file ends within its header", cut_hint, at_);
        at_ += 4;
        return integer_at(at_ - 4);
    }

    std::int32_t integer_at(std::size_t offset) const {
        std::uint32_t value = 0;
        for (unsigned i = 0; i < 4; ++i)
            value |= std::to_integer<std::uint32_t>(bytes_[offset + i]) << (8 * i);
        return static_cast<std::int32_t>(value);
    }

    [[noreturn]] void refuse(const std::string& message, const std::string& hint, std::size_t byte) const {
        refuse_picture(name_, message, hint, byte);
    }

    std::span<const std::byte> bytes_;
    const std::string& name_;
    std::size_t at_ = 0;
};

using ChannelNames = std::array<const char*, 3>;

/// R, G and B, or Y for all three.
ChannelNames choose_channels(const Imf::ChannelList& list, const std::string& name) {
    const auto has = [&](const char* channel) { return list.findChannel(channel) != nullptr; };
    if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
    if (has("Y") && !has("RY") && !has("BY")) return {"Y", "Y", "Y"};

    std::string found;
    for (auto channel = list.begin(); channel != list.end(); ++channel)
        found += std::string(found.empty() ? "" : ", ") + channel.name();
    refuse_picture(name, "the EXR has neither R, G and B nor Y alone (it has: " + found + ")",
                   "save it with the channels R, G and B");
}

/// Reads rows in blocks and grows the image with them, so a file that claims too many rows fails before much
/// memory is used.
LoadedPicture read_rows(Imf::InputFile& file, const Window& window, const ChannelNames& channels) {
    constexpr std::int64_t block_rows = 64;
    LoadedPicture picture;
    Image& image = picture.image;
    // Memory is used as rows come.
    image.pixels.reserve(static_cast<std::size_t>(3 * window.width() * window.height()));
    image.width = static_cast<int>(window.width());
    const std::size_t row = 3 * static_cast<std::size_t>(image.width);
    std::vector<float> planes(row * block_rows);
    const bool has_alpha = file.header().channels().findChannel("A") != nullptr;
    std::vector<float> alphas(has_alpha ? row / 3 * block_rows : 0);
    if (has_alpha) picture.alpha.reserve(static_cast<std::size_t>(window.width() * window.height()));

    for (std::int64_t first = window.min_y; first <= window.max_y; first += block_rows) {
        const auto last = std::min<std::int64_t>(first + block_rows - 1, window.max_y);
        const auto rows = static_cast<std::size_t>(last - first + 1);
        Imf::FrameBuffer buffer;
        const Imath::Box2i block({window.min_x, static_cast<int>(first)},
                                 {window.max_x, static_cast<int>(last)});
        const bool gray = std::string_view(channels[0]) == channels[1];
        for (std::size_t i = 0; i < (gray ? 1U : 3U); ++i)
            buffer.insert(channels[i], Imf::Slice::Make(Imf::FLOAT, planes.data() + i, block,
                                                        3 * sizeof(float), row * sizeof(float)));
        if (has_alpha)
            buffer.insert("A", Imf::Slice::Make(Imf::FLOAT, alphas.data(), block, sizeof(float),
                                                row / 3 * sizeof(float)));
        file.setFrameBuffer(buffer);
        file.readPixels(static_cast<int>(first), static_cast<int>(last));

        if (gray)
            for (std::size_t i = 0; i < rows * row; i += 3) planes[i + 1] = planes[i + 2] = planes[i];
        image.pixels.insert(image.pixels.end(), planes.begin(),
                            planes.begin() + static_cast<std::ptrdiff_t>(rows * row));
        if (has_alpha)
            picture.alpha.insert(picture.alpha.end(), alphas.begin(),
                                 alphas.begin() + static_cast<std::ptrdiff_t>(rows * row / 3));
        image.height += static_cast<int>(rows);
    }
    return picture;
}

} // namespace

LoadedPicture decode_exr(std::span<const std::byte> bytes, const std::string& name) {
    const Window window = HeaderCheck(bytes, name).run();
    check_picture_size(name, window.width(), window.height());
    require_picture_memory(name, window.width(), window.height(), 3 * sizeof(float));
    try {
        return twice([&] {
            MemoryInput input(bytes);
            Imf::InputFile file(input, 0);
            return read_rows(file, window, choose_channels(file.header().channels(), name));
        });
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& problem) {
        refuse_picture(name, std::string("damaged EXR: ") + problem.what(), cut_hint);
    }
}

} // namespace glint::formats
