// Reading and writing PFM files.

#include "formats/picture/codecs.h"
#include "scene/text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

namespace glint::formats {

namespace {

/// Position of row y, counted from the top, in the file: rows are stored bottom-up.
std::size_t file_row(int y, int height) { return static_cast<std::size_t>(height - 1 - y); }

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

struct PfmHeader {
    int channels = 3;
    int width = 0;
    int height = 0;
    bool little_endian = true;
    std::size_t size = 0; ///< bytes of the header
};

/// Parses the header: words separated by white space, then exactly one white-space character before the
/// pixels.
class PfmHeaderReader {
  public:
    PfmHeaderReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    PfmHeader read() {
        PfmHeader header;
        const std::string_view kind = word();
        if (kind != "PF" && kind != "Pf") fail("the first line is not 'PF' or 'Pf'");
        header.channels = kind == "PF" ? 3 : 1;
        header.width = number<int>("the width");
        header.height = number<int>("the height");
        check_picture_size(name_, header.width, header.height);

        const auto scale = number<double>("the scale");
        if (scale == 0 || !std::isfinite(scale)) fail("the scale is neither positive nor negative");
        header.little_endian = scale < 0;
        header.size = at_ + 1;
        return header;
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        refuse_picture(name_, message, "a PFM file begins with 'PF', width and height, and -1.0 or 1.0",
                       start_);
    }

    std::string_view word() {
        while (at_ < text_.size() && is_space(text_[at_])) ++at_;
        start_ = at_;
        while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        if (at_ == text_.size()) fail("the file ends within its header");
        return text_.substr(start_, at_ - start_);
    }

    template <class Number>
    Number number(const std::string& what) {
        const auto value = scene::parse_number<Number>(word());
        if (!value) fail(what + " is no valid number");
        return *value;
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    std::size_t start_ = 0; ///< offset of the last word read
};

float float_from_bytes(const std::byte* bytes, bool little_endian) {
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < 4; ++i)
        bits |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * (little_endian ? i : 3 - i));
    return std::bit_cast<float>(bits);
}

} // namespace

PfmFile::PfmFile(const Image& image)
    : header_("PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n") {
    std::span<const std::byte> pixels = std::as_bytes(std::span(image.pixels));
    if constexpr (std::endian::native != std::endian::little) {
        turned_.assign(pixels.begin(), pixels.end());
        for (std::size_t i = 0; i < turned_.size(); i += 4) std::reverse(&turned_[i], &turned_[i] + 4);
        pixels = turned_;
    }
    const std::size_t row = 3 * sizeof(float) * static_cast<std::size_t>(image.width);
    pieces_.push_back(std::as_bytes(std::span(header_)));
    for (int y = 0; y < image.height; ++y)
        pieces_.push_back(pixels.subspan(row * file_row(y, image.height), row));
}

LoadedPicture decode_pfm(std::span<const std::byte> bytes, const std::string& name) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const PfmHeader header = PfmHeaderReader(text, name).read();

    // The header determines the exact size of the file, so check it before allocating memory.
    const auto row_bytes =
        static_cast<std::size_t>(4 * header.channels) * static_cast<std::size_t>(header.width);
    const std::size_t expected = row_bytes * static_cast<std::size_t>(header.height);
    const std::size_t found = bytes.size() - header.size;
    if (found != expected)
        refuse_picture(
            name,
            std::to_string(found) + " bytes of pixels where the header promises " + std::to_string(expected),
            found < expected ? cut_hint : "the header's width and height do not fit the file", header.size);

    LoadedPicture picture;
    picture.image = Image(header.width, header.height);
    for (int y = 0; y < header.height; ++y) {
        const std::byte* from = bytes.data() + header.size + row_bytes * file_row(y, header.height);
        float* to = picture.image.at(0, y);
        for (int i = 0; i < 3 * header.width; ++i) {
            const int value = header.channels == 3 ? i : i / 3;
            to[i] = float_from_bytes(from + 4 * value, header.little_endian);
        }
    }
    return picture;
}

} // namespace glint::formats
