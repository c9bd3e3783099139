#pragma once
// Picture files. Readers throw Error(input) with place, cause and cure; writers write the whole file or
// nothing and throw Error(output).

#include "glint/error.h"
#include "glint/image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint {

enum class View { srgb, raw };

/// One named picture beside the main one: a term of the light, or coverage.
struct Layer {
    std::string name;
    Image image;
};

struct PictureOptions {
    View view = View::srgb;
    int bits = 8;              ///< PNG: 8 or 16
    std::vector<float> alpha;  ///< PNG, EXR: width · height values, straight; empty: none
    std::vector<Layer> layers; ///< EXR
    std::vector<std::pair<std::string, std::string>>
        metadata; ///< what decides the picture; PNG text, EXR attributes
};

/// What a screen shows of a picture: the codes that an 8-bit PNG would hold, a pixel packed as 0xffRRGGBB,
/// rows from the top. `pixels` takes the picture's size.
void screen_pixels(const Image& image, View view, std::vector<std::uint32_t>& pixels);

enum class PictureFormat { png, exr, pfm };

/// By the extension of a name, in any case; "-" (stdout) is PNG. None for any other.
std::optional<PictureFormat> picture_format(const std::string& path);

/// Writes .png, .exr or .pfm by the extension; "-" is stdout (as PNG).
void write_picture(const std::string& path, const Image& image, const PictureOptions& options = {});

/// Throws what write_picture() would throw for the path alone: Error(usage) for an extension that is none of
/// the three or cannot hold alpha or layers, Error(output) for a missing folder or permission. Writes
/// nothing: call it before a long render.
void check_picture_target(const std::string& path, bool with_alpha = false, bool with_layers = false);

/// A picture as read: 8- and 16-bit ones hold their integer values, float ones linear light.
struct LoadedPicture {
    Image image;
    int bits = 32; ///< 8, 16, or 32 for float
};
LoadedPicture read_picture(const std::string& path);

/// What `glint diff` compares: |a − b| in units of 1/255 where both pictures have 8 or 16 bits, linear light
/// where both are float. One of each is refused with Error(usage), different sizes with Error(input).
struct PictureDifference {
    Comparison comparison;
    bool eight_bit = false; ///< units of 1/255
};
PictureDifference diff_pictures(const LoadedPicture& a, const LoadedPicture& b, double tolerance);

} // namespace glint
