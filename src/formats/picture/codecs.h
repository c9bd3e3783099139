#pragma once
// Encoders and decoders of picture formats; picture.cpp chooses among them.

#include "formats/write_file.h"
#include "glint/picture_files.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint::formats {

/// Encodes a whole file. The arguments are those of write_picture(), already validated.
std::vector<std::byte> encode_png(const Image& image, const PictureOptions& options);
std::vector<std::byte> encode_exr(const Image& image, const PictureOptions& options);

/// A PFM file: "PF", little endian, rows bottom-up, RGB only. Its pieces point into the image, which must
/// outlive it.
class PfmFile {
  public:
    explicit PfmFile(const Image& image);
    PfmFile(const PfmFile&) = delete;
    PfmFile& operator=(const PfmFile&) = delete;
    Pieces pieces() const { return pieces_; }

  private:
    std::string header_;
    std::vector<std::byte> turned_; ///< byte-swapped pixels on big-endian machines
    std::vector<std::span<const std::byte>> pieces_;
};

/// Decoders of whole files; `name` is the file name for messages. They throw Error(input) for truncated,
/// inconsistent or unsupported files, and allocate memory only in proportion to the file size.

/// Any of the three formats, recognized by the first bytes.
LoadedPicture decode_picture(std::span<const std::byte> bytes, const std::string& name);
/// Gray, palette and RGB of any depth, with 1 to 8 bits expanded to 8; gamma is ignored.
LoadedPicture decode_png(std::span<const std::byte> bytes, const std::string& name);
/// Single-part scan-line files; R, G and B, or only Y, and A if there is one, of any type; the picture is the
/// data window.
LoadedPicture decode_exr(std::span<const std::byte> bytes, const std::string& name);
/// "PF", and "Pf" as three equal channels; both byte orders. The magnitude of the scale is ignored, as in
/// most readers.
LoadedPicture decode_pfm(std::span<const std::byte> bytes, const std::string& name);

/// Throws Error(input) for a picture file, at a byte offset if given.
[[noreturn]] void refuse_picture(const std::string& name, const std::string& message, const std::string& hint,
                                 std::optional<std::uint64_t> byte = {});

/// "640 x 480".
std::string size_text(std::int64_t width, std::int64_t height);

/// Throws unless the size is 1 … 65,536 on each side and at most 2^30 pixels.
void check_picture_size(const std::string& name, std::int64_t width, std::int64_t height);

/// Throws Error(resource) where there is no memory for pixels of so many bytes each, and `more` bytes to read
/// them.
void require_picture_memory(const std::string& name, std::int64_t width, std::int64_t height,
                            std::size_t pixel_bytes, double more = 0);

/// Bytes of all channels of a picture that is written, as floats.
std::size_t channel_bytes(const Image& image, const PictureOptions& options);

/// Hint for truncated or damaged files.
inline constexpr const char* cut_hint = "the file is cut short or damaged; write or copy it again";

} // namespace glint::formats
