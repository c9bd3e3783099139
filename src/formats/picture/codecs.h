#pragma once
// Between pictures and the bytes of their files, a way in and a way out for each format; picture.cpp chooses.

#include "formats/write_file.h"
#include "glint/formats.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint {

/// The bytes of a whole file. The arguments are those of write_picture(), already checked by it.
std::vector<std::byte> encode_png(const Image& image, const PictureOptions& options);
std::vector<std::byte> encode_exr(const Image& image, const PictureOptions& options);

/// An image as a PFM file: "PF", little endian, rows from the bottom; holds nothing but RGB. Its pieces are
/// the image's own rows, so the image must stay.
class PfmFile {
  public:
    explicit PfmFile(const Image& image);
    PfmFile(const PfmFile&) = delete;
    PfmFile& operator=(const PfmFile&) = delete;
    Pieces pieces() const { return pieces_; }

  private:
    std::string header_;
    std::vector<std::byte> turned_; ///< the pixels, where the machine's floats begin at their other end
    std::vector<std::span<const std::byte>> pieces_;
};

/// The picture in the bytes of a whole file; `name` stands for the file in messages. Throws Error(input) for
/// bytes that are cut, lie or cannot be understood. Memory is taken only as far as the number of bytes can
/// justify it.

/// Any of the three, told apart by their first bytes.
LoadedPicture decode_picture(std::span<const std::byte> bytes, const std::string& name);
/// Gray, palette and RGB of any depth, 1 to 8 bits as 8; transparency is left out, gamma is not applied.
LoadedPicture decode_png(std::span<const std::byte> bytes, const std::string& name);
/// Single-part files by scan lines; R, G and B, or Y alone, of any type; the picture is the data window.
LoadedPicture decode_exr(std::span<const std::byte> bytes, const std::string& name);
/// "PF" and, as equal channels, "Pf"; both byte orders. The size of the scale is ignored, as most readers do.
LoadedPicture decode_pfm(std::span<const std::byte> bytes, const std::string& name);

/// Throws Error(input) about a picture file, at a byte of it where one can be named.
[[noreturn]] void refuse_picture(const std::string& name, const std::string& message, const std::string& hint,
                                 std::optional<std::uint64_t> byte = {});

/// Refuses a size that a file claims: 1 … 65,536 a side and at most 2^30 pixels.
void check_picture_size(const std::string& name, std::int64_t width, std::int64_t height);

/// The cure for a file that is cut or garbled.
inline constexpr const char* cut_hint = "the file is cut short or damaged; write or copy it again";

} // namespace glint
