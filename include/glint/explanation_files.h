#pragma once
// Explanations as text, JSON, SVG and HTML.

#include "glint/explanation.h"
#include "glint/image.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint {

/// What explanation_text() shows.
struct ExplanationTextOptions {
    int sample = 0;         ///< the sample whose rays are shown
    std::optional<int> ray; ///< only this one of its rays, with every step
    bool steps = false;     ///< all its rays with every step
    bool color = false;     ///< adds terminal escape sequences
};

/// UTF-8 text: the pixel, its samples, and the ray tree of one sample with a line for each ray. Branches that
/// bring less than a thousandth of the sample's light are counted. Steps have 6 digits. Throws Error(usage)
/// for a sample or a ray that does not exist.
std::string explanation_text(const Explanation& explanation, const ExplanationTextOptions& options = {});

/// "0.5", or "(1, 0, 0.25)".
std::string quantity_text(const Quantity& q, int digits = 6);

/// The formula of a step with numbers in place of symbols, as printed by explanation_text(); empty if it
/// would repeat the formula or the result. `light`: the light the step belongs to, if any.
std::string formula_in_numbers(const Step& step, const ExplainedRay& ray,
                               const ExplainedLight* light = nullptr);

/// The pixel of a graphics card and its difference from the explanation: "on DEVICE it is (…), off by at most
/// …".
std::string other_pixel_text(const Explanation& explanation, const OtherPixel& other, int digits = 6);

/// JSON with nine digits, which parse to the same floats; docs/explain.md lists the names.
std::string explanation_json(const Explanation& explanation);

/// The ray trees as an SVG picture.
std::string explanation_svg(const Explanation& explanation);

/// Input of explanation_html().
struct ExplanationPage {
    std::string scene;                   ///< title
    Image image;                         ///< the picture
    std::array<Image, term_count> terms; ///< its terms as returned by render()
    std::string gpu;                     ///< name of the graphics card that rendered gpu_image; empty if none
    Image gpu_image;                     ///< the picture of the graphics card, for comparison
    int columns = 160; ///< the page contains explanations of a grid of pixels, at most one per pixel:
    int rows = 90;     ///< at the centres of the cells of an even grid
    /// The pixel that is shown first, in place of the centre of its cell; none: the middle of the picture.
    std::optional<PixelCoord> pixel;
    /// Called for the pixels of one row after another; the rays of the first sample of each pixel are shown.
    std::function<std::vector<Explanation>(std::span<const PixelCoord> row)> explain;
    std::size_t max_bytes = 9'900'000; ///< size limit: rays with the smallest contribution are omitted
};

/// An interactive picture as one self-contained HTML file: terms can be switched on and off, and the rays
/// under the mouse are shown with all terms.
std::string explanation_html(const ExplanationPage& page);

} // namespace glint
