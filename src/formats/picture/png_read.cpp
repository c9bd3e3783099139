// Reading PNG files with libpng.

#include "formats/picture/codecs.h"
#include "formats/picture/png_guard.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>

namespace glint::formats {

namespace {

/// The bytes not read yet.
struct PngInput {
    std::span<const std::byte> left;
};

void take_bytes(png_structp png, png_bytep out, std::size_t size) {
    auto* input = static_cast<PngInput*>(png_get_io_ptr(png));
    if (size > input->left.size()) png_error(png, "the data end early");
    std::memcpy(out, input->left.data(), size);
    input->left = input->left.subspan(size);
}

/// Owns libpng's state for reading one file from memory.
class PngReader {
  public:
    PngReader(std::span<const std::byte> bytes, const std::string& name)
        : input_{bytes}, name_(name), size_(bytes.size()),
          png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure_, png_fail, png_ignore)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ == nullptr) throw std::bad_alloc();
        png_set_read_fn(png_, &input_, take_bytes);
        // check_picture_size() checks sizes, with a clearer message than libpng's.
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        // Texts and profiles may grow when decompressed.
        constexpr std::size_t max_grown = 1U << 23U;
        png_set_chunk_malloc_max(png_, std::max(bytes.size(), max_grown));
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    template <class Calls>
    void run(const Calls& calls) {
        if (png_try(png_, calls)) return;
        throw_if_out_of_memory(failure_);
        refuse_picture(name_, std::string("damaged PNG: ") + failure_.message.data(), cut_hint,
                       size_ - input_.left.size());
    }

    png_structp png() { return png_; }
    png_infop info() { return info_; }

  private:
    PngFailure failure_;
    PngInput input_;
    const std::string& name_;
    std::size_t size_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// Checks that chunks end within the file: libpng allocates what they claim.
void check_chunks(std::span<const std::byte> bytes, const std::string& name) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    constexpr std::size_t head = 8; // length and name; the content and a check sum of 4 bytes follow
    for (std::size_t at = 8; at + head <= bytes.size() && text.substr(at + 4, 4) != "IEND";) {
        std::size_t length = 4;
        for (std::size_t i = 0, unit = 1U << 24U; i < 4; ++i, unit >>= 8U)
            length += unit * std::to_integer<std::size_t>(bytes[at + i]);
        if (length > bytes.size() - at - head)
            refuse_picture(name, "damaged PNG: a chunk is longer than the file", cut_hint, at);
        at += head + length;
    }
}

struct PngShape {
    png_uint_32 width = 0;
    png_uint_32 height = 0;
    std::size_t bits_per_pixel = 0; ///< in the file
    std::size_t row_bytes = 0;      ///< as decoded: RGB or RGBA with 8 or 16 bits
    std::size_t channels = 3;
    int bits = 8;
    int passes = 1; ///< more than one if interlaced
};

/// Reads the header.
PngShape read_header(PngReader& reader) {
    PngShape shape;
    png_structp png = reader.png();
    png_infop info = reader.info();
    reader.run([&] {
        png_read_info(png, info);
        shape.width = png_get_image_width(png, info);
        shape.height = png_get_image_height(png, info);
        shape.bits_per_pixel = std::size_t{png_get_bit_depth(png, info)} * png_get_channels(png, info);
    });
    return shape;
}

/// Asks libpng to convert to RGB, or RGBA if anything is transparent, with 8 or 16 bits.
void request_rgb(PngReader& reader, PngShape& shape) {
    png_structp png = reader.png();
    png_infop info = reader.info();
    reader.run([&] {
        png_set_expand(png);
        png_set_gray_to_rgb(png);
        shape.passes = png_set_interlace_handling(png);
        png_read_update_info(png, info);
        shape.bits = png_get_bit_depth(png, info);
        shape.row_bytes = png_get_rowbytes(png, info);
        shape.channels = png_get_channels(png, info);
    });
}

/// Throws for a file too short for its pixels, before memory is allocated for them: deflate makes at most
/// 1032 bytes of one.
void check_data_size(const std::string& name, const PngShape& shape, std::size_t file_size) {
    constexpr std::size_t max_ratio = 1032;
    if (shape.bits_per_pixel * shape.width / 8 * shape.height / max_ratio > file_size)
        refuse_picture(name, "the PNG is too short for " + size_text(shape.width, shape.height) + " pixels",
                       cut_hint);
}

LoadedPicture picture_from_rows(const PngShape& shape, const png_byte* rows) {
    // 16-bit values are big-endian.
    const auto value = [&](std::size_t i) {
        return static_cast<float>(shape.bits == 16 ? rows[2 * i] * 256U + rows[2 * i + 1] : rows[i]);
    };
    LoadedPicture picture{Image(static_cast<int>(shape.width), static_cast<int>(shape.height)), shape.bits};
    const std::size_t pixels = picture.image.pixels.size() / 3;
    if (shape.channels == 4) picture.alpha.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t k = 0; k < 3; ++k) picture.image.pixels[3 * i + k] = value(shape.channels * i + k);
        if (shape.channels == 4) picture.alpha[i] = value(4 * i + 3);
    }
    return picture;
}

} // namespace

LoadedPicture decode_png(std::span<const std::byte> bytes, const std::string& name) {
    check_chunks(bytes, name);
    PngReader reader(bytes, name);
    PngShape shape = read_header(reader);
    check_picture_size(name, shape.width, shape.height);
    check_data_size(name, shape, bytes.size());
    request_rgb(reader, shape);
    const std::size_t pixel_bytes = shape.row_bytes / shape.width + shape.channels * sizeof(float);
    require_picture_memory(name, shape.width, shape.height, pixel_bytes);

    // Interlaced rows come in several passes, so all rows are kept. Their memory is used as they come: a file
    // may claim more than it holds.
    const auto rows = std::make_unique_for_overwrite<png_byte[]>(shape.row_bytes * shape.height);
    png_structp png = reader.png();
    reader.run([&] {
        for (int pass = 0; pass < shape.passes; ++pass)
            for (std::size_t y = 0; y < shape.height; ++y)
                png_read_row(png, rows.get() + y * shape.row_bytes, nullptr);
        png_read_end(png, nullptr);
    });

    return picture_from_rows(shape, rows.get());
}

} // namespace glint::formats
