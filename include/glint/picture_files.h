#pragma once
// Picture files. Readers throw Error(input) with location, cause and cure; writers write the whole file or
// nothing and throw Error(output).

#include "glint/enum_names.h"
#include "glint/error.h"
#include "glint/image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint {

enum class View { srgb, raw };

/// A named picture in addition to the main one: a term of the light, or coverage.
struct Layer {
    std::string name;
    Image image;
};

struct PictureOptions {
    View view = View::srgb;
    int bits = 8; ///< PNG: 8 or 16
    /// PNG, EXR: width · height values, by which the image is premultiplied; PNG stores straight colours.
    /// Empty: no alpha.
    std::vector<float> alpha;
    std::vector<Layer> layers; ///< EXR
    /// EXR: where the image stands in a larger picture, as with --crop: its first pixel, and the size of the
    /// whole; a size of 0: the image is the whole.
    int x = 0, y = 0, full_width = 0, full_height = 0;
    /// settings that determine the picture, as PNG text or EXR attributes
    std::vector<std::pair<std::string, std::string>> metadata;
};

/// Converts to 8-bit codes for display, packed as 0xffRRGGBB, rows from the top. Resizes `pixels`.
void screen_pixels(const Image& image, View view, std::vector<std::uint32_t>& pixels);

enum class PictureFormat { png, exr, pfm };
template <>
inline constexpr NamesUpTo<PictureFormat::pfm> enum_names<PictureFormat>{"png", "exr", "pfm"};

/// By the extension of a name, in any case; "-" (stdout) is PNG, and so are pipes and devices without an
/// extension. None for any other.
std::optional<PictureFormat> picture_format(const std::string& path);

/// Writes .png, .exr or .pfm, chosen by the extension; "-" writes PNG to stdout.
void write_picture(const std::string& path, const Image& image, const PictureOptions& options = {});

/// Throws what write_picture() would throw for this path: Error(usage) for an unsupported extension or one
/// that cannot hold alpha or layers, Error(output) for a missing folder or permission. Writes nothing: for
/// use before a long render.
void check_picture_target(const std::string& path, bool with_alpha = false, bool with_layers = false);

/// A picture as read: 8- and 16-bit pictures keep integer values, float pictures are linear light.
struct LoadedPicture {
    Image image;
    int bits = 32;                 ///< 8, 16, or 32 for float
    std::vector<float> alpha = {}; ///< by pixel, in the same units; empty: opaque
};
LoadedPicture read_picture(const std::string& path);

/// The comparison of `glint diff`: |a − b| in units of 1/255 if both pictures have 8 or 16 bits, in linear
/// light if both are float. Alpha counts if either has it. Throws Error(usage) for one of each, Error(input)
/// for different sizes.
struct PictureDifference {
    Comparison comparison;
    bool eight_bit = false; ///< units of 1/255
};
PictureDifference diff_pictures(const LoadedPicture& a, const LoadedPicture& b, double tolerance);

} // namespace glint
