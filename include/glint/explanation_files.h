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

/// A readable tree of 6 digits, UTF-8; `color` adds a terminal's escape sequences.
std::string explanation_text(const Explanation& explanation, bool color = false);

/// "0.5", or "(1, 0, 0.25)".
std::string quantity_text(const Quantity& q, int digits = 6);

/// The formula of a step with its numbers for its symbols, as explanation_text() prints it; empty where it
/// would say no more than the formula or the result. `light`: whose step it is, else the ray's own.
std::string formula_in_numbers(const Step& step, const ExplainedRay& ray,
                               const ExplainedLight* light = nullptr);

/// What a graphics card makes of the pixel, and how far that is from the explanation:
/// "on DEVICE it is (…), off by at most …".
std::string other_pixel_text(const Explanation& explanation, const OtherPixel& other, int digits = 6);

/// JSON with nine digits, which read back as the same floats; docs/explain.md lists the names.
std::string explanation_json(const Explanation& explanation);

/// A picture of the trees: SVG, for reading and for showing around.
std::string explanation_svg(const Explanation& explanation);

/// What explanation_html() makes a page of.
struct ExplanationPage {
    std::string scene;                   ///< title
    Image image;                         ///< the picture, and
    std::array<Image, term_count> terms; ///< its terms, as render() gives them
    std::string gpu;                     ///< the graphics card that rendered gpu_image; empty: none did
    Image gpu_image;                     ///< the picture from there, to be compared with
    int columns = 160; ///< the page holds the explanations of so many places, at most one a pixel:
    int rows = 90;     ///< the middles of an even grid
    /// Asked for the places of one row after the other; of each the rays of its first sample are shown.
    std::function<std::vector<Explanation>(std::span<const PixelCoord> row)> explain;
    std::size_t max_bytes = 9'900'000; ///< rays that bring least are left out until the page is no larger
};

/// A picture that can be asked, as one HTML file that needs no network: its terms can be switched on and off,
/// and where the mouse is, the rays of the place are shown with every term.
std::string explanation_html(const ExplanationPage& page);

} // namespace glint
