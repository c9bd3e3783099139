#pragma once
// Explanations as text, JSON, SVG and HTML.

#include "glint/explanation.h"
#include "glint/image.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace glint {

/// A text tree with 6 digits, in UTF-8; `color` adds terminal escape sequences.
std::string explanation_text(const Explanation& explanation, bool color = false);

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
    /// Called for the pixels of one row after another; the rays of the first sample of each pixel are shown.
    std::function<std::vector<Explanation>(std::span<const PixelCoord> row)> explain;
    std::size_t max_bytes = 9'900'000; ///< size limit: rays with the smallest contribution are omitted
};

/// An interactive picture as one self-contained HTML file: terms can be switched on and off, and the rays
/// under the mouse are shown with all terms.
std::string explanation_html(const ExplanationPage& page);

} // namespace glint
