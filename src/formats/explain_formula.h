#pragma once
// Formulas as text: their numbers found, printed and put in.

#include "glint/explanation.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glint {

/// The given and computed quantities that a formula may name, nearest last.
class Scope {
  public:
    /// Of a whole ray, or of one of its lights.
    explicit Scope(const ExplainedRay& ray, const ExplainedLight* light = nullptr);

    /// The quantities that a formula names, each once, in the order of the formula.
    std::vector<const Step*> named_in(std::string_view formula) const;
    /// The formula with its numbers for its symbols.
    std::string filled_in(std::string_view formula, int digits) const;

  private:
    const Step* find(std::string_view symbol) const;
    /// Calls part(text, step): step is null for what is no symbol.
    template <class Part>
    void split(std::string_view formula, const Part& part) const;

    std::vector<const std::vector<Step>*> lists_;
};

/// A number with so many digits, as short as it can be; "∞" where it is infinite.
std::string number_text(float x, int digits);
/// "0.5", or "(1, 0, 0.25)".
std::string quantity_text(const Quantity& q, int digits);

/// What a graphics card makes of the pixel, and how far that is from the explanation, which must have it:
/// "on DEVICE it is (…), off by at most …".
std::string other_pixel_text(const Explanation& explanation, int digits);

} // namespace glint
