#pragma once
// The header of an EXR file, checked before OpenEXR reads it.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace glint::formats {

/// The first and the last column and row of pixels.
struct ExrWindow {
    std::int32_t min_x = 0;
    std::int32_t min_y = 0;
    std::int32_t max_x = -1;
    std::int32_t max_y = -1;
    std::int64_t width() const { return std::int64_t{max_x} - min_x + 1; }
    std::int64_t height() const { return std::int64_t{max_y} - min_y + 1; }
};

struct ExrHeader {
    std::size_t bytes = 0;     ///< its length
    ExrWindow window;          ///< the data window
    double pixel_bytes = 0;    ///< of a pixel in the file, all channels, uncompressed
    int rows_of_a_block = 256; ///< rows that are compressed together
};

/// Reads a header. Throws Error(input) for one that is damaged, with the byte at which the attribute begins:
/// OpenEXR reads values of the types it knows by lengths in the values themselves, not by the length of the
/// attribute, and allocates what they claim.
ExrHeader read_exr_header(std::span<const std::byte> bytes, const std::string& name);

/// Does the file have every block of rows? OpenEXR leaves out those for which zlib lacks memory.
bool has_all_blocks(std::span<const std::byte> file);

} // namespace glint::formats
