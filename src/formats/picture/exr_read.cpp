// Reading EXR files with OpenEXR.

#include "formats/picture/codecs.h"
#include "formats/picture/exr_header.h"
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
LoadedPicture read_rows(Imf::InputFile& file, const ExrWindow& window, const ChannelNames& channels) {
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
    const ExrHeader header = read_exr_header(bytes, name);
    const ExrWindow& window = header.window;
    check_picture_size(name, window.width(), window.height());
    // With alpha; and a block as it is read, decompressed, and once or twice within the decompressor.
    constexpr double copies = 4;
    require_picture_memory(name, window.width(), window.height(), 4 * sizeof(float),
                           copies * header.pixel_bytes * header.rows_of_a_block * double(window.width()));
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
