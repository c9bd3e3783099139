// Writing PNG files with libpng.

#include "formats/picture/codecs.h"
#include "formats/picture/png_guard.h"
#include "imaging/tone.h"

#include <png.h>

#include <algorithm>
#include <new>

namespace glint::formats {

namespace {

/// Chosen for speed: about 20 % larger files than with libpng's defaults in a fifth of the time.
constexpr int compression_level = 4;
constexpr int row_filters = PNG_FILTER_SUB;

/// Owns libpng's state for writing one file to memory.
class PngWriter {
  public:
    PngWriter() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure_, png_fail, png_ignore)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ == nullptr) throw std::bad_alloc();
        png_set_write_fn(png_, &bytes_, append, flush);
    }
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    template <class Calls>
    void run(const Calls& calls) {
        if (png_try(png_, calls)) return;
        throw_if_out_of_memory(failure_);
        throw Error(ErrorKind::internal, std::string("cannot encode the PNG: ") + failure_.message.data());
    }

    png_structp png() { return png_; }
    png_infop info() { return info_; }
    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    /// No exception may propagate through libpng: lack of memory becomes a libpng error.
    static void append(png_structp png, png_bytep data, std::size_t size) {
        auto* bytes = static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
        if (!try_append(*bytes, data, size)) png_error(png, "not enough memory");
    }
    static bool try_append(std::vector<std::byte>& bytes, const png_byte* data, std::size_t size) noexcept {
        try {
            const auto* first = reinterpret_cast<const std::byte*>(data);
            bytes.insert(bytes.end(), first, first + size);
            return true;
        } catch (const std::bad_alloc&) {
            return false;
        }
    }
    static void flush(png_structp) {}

    PngFailure failure_;
    std::vector<std::byte> bytes_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// Encodes rows; 16-bit codes are big-endian as PNG requires.
class RowEncoder {
  public:
    RowEncoder(const Image& image, const PictureOptions& options) : image_(image), options_(options) {
        const std::size_t channels = options.alpha.empty() ? 3 : 4;
        row_.resize(static_cast<std::size_t>(image.width) * channels * (options.bits == 16 ? 2 : 1));
    }

    png_bytep row() { return row_.data(); }

    void encode(int y) {
        const bool raw = options_.view == View::raw;
        if (options_.bits == 8)
            fill(y, raw ? imaging::raw8_from_linear : imaging::srgb8_from_linear, imaging::unorm8_from_float);
        else
            fill(y, raw ? imaging::raw16_from_linear : imaging::srgb16_from_linear,
                 imaging::unorm16_from_float);
    }

  private:
    template <class Code>
    void fill(int y, Code code_of_light, Code code_of_alpha) {
        png_bytep to = row_.data();
        const float* from = image_.at(0, y);
        const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width);
        for (std::size_t x = 0; x < static_cast<std::size_t>(image_.width); ++x) {
            const float alpha = options_.alpha.empty() ? 1 : options_.alpha[first + x];
            for (std::size_t channel = 0; channel < 3; ++channel)
                to = put(to, code_of_light(straight(from[3 * x + channel], alpha)));
            if (!options_.alpha.empty()) to = put(to, code_of_alpha(alpha));
        }
    }

    /// The colour without its factor alpha, and black where nothing is.
    static float straight(float premultiplied, float alpha) {
        if (alpha >= 1) return premultiplied;
        return alpha > 0 ? premultiplied / alpha : 0;
    }

    static png_bytep put(png_bytep to, std::uint8_t code) {
        *to = code;
        return to + 1;
    }
    static png_bytep put(png_bytep to, std::uint16_t code) {
        to[0] = static_cast<png_byte>(code >> 8U);
        to[1] = static_cast<png_byte>(code & 255U);
        return to + 2;
    }

    const Image& image_;
    const PictureOptions& options_;
    std::vector<png_byte> row_;
};

bool is_ascii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

/// PNG limits keywords to 1 to 79 characters of Latin-1; this accepts ASCII only.
void check_keyword(const std::string& key) {
    constexpr std::size_t max_length = 79;
    const bool printable = std::all_of(key.begin(), key.end(), [](char c) { return c >= ' ' && c <= '~'; });
    const bool trimmed = key.front() != ' ' && key.back() != ' ' && key.find("  ") == std::string::npos;
    if (!printable || !trimmed || key.size() > max_length)
        throw Error(ErrorKind::usage, "'" + key + "' cannot name metadata in a PNG",
                    "take up to 79 printable ASCII characters without leading, trailing or double spaces");
}

/// Text chunks that point into the metadata: tEXt if ASCII suffices, otherwise iTXt (UTF-8).
std::vector<png_text> text_chunks(const PictureOptions& options) {
    std::vector<png_text> texts;
    static char none[] = "";
    for (const auto& [key, value] : options.metadata) {
        check_keyword(key);
        png_text text{};
        text.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        // libpng takes non-const pointers but only reads.
        text.key = const_cast<char*>(key.c_str());
        text.text = const_cast<char*>(value.c_str());
        text.text_length = value.size();
        text.lang = none;
        text.lang_key = none;
        texts.push_back(text);
    }
    return texts;
}

void write_header(PngWriter& writer, const Image& image, const PictureOptions& options) {
    const std::vector<png_text> texts = text_chunks(options);
    png_structp png = writer.png();
    png_infop info = writer.info();
    writer.run([&] {
        png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                     options.bits, options.alpha.empty() ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        // No chunk describes the raw view.
        if (options.view == View::srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        if (!texts.empty()) png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));

        png_set_compression_level(png, compression_level);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, row_filters);
        png_write_info(png, info);
    });
}

} // namespace

std::vector<std::byte> encode_png(const Image& image, const PictureOptions& options) {
    PngWriter writer;
    write_header(writer, image, options);
    RowEncoder rows(image, options);
    png_structp png = writer.png();
    writer.run([&] {
        for (int y = 0; y < image.height; ++y) {
            rows.encode(y);
            png_write_row(png, rows.row());
        }
        png_write_end(png, writer.info());
    });
    return writer.take();
}

} // namespace glint::formats
