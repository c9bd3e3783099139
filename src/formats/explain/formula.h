#pragma once
// Formulas as text: finding symbols and inserting numbers.

#include "glint/explanation.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glint::formats {

/// The quantities that a formula may refer to, innermost last.
class Scope {
  public:
    /// Scope of a ray, or of one of its lights.
    explicit Scope(const ExplainedRay& ray, const ExplainedLight* light = nullptr);

    /// The quantities a formula refers to, each once, in order.
    std::vector<const Step*> named_in(std::string_view formula) const;
    /// The formula with numbers in place of symbols; empty if that adds nothing.
    std::string filled_in(const Step& step) const;

  private:
    const Step* find(std::string_view symbol) const;
    /// Calls part(text, step) for each part; step is null unless it is a symbol.
    template <class Part>
    void split(std::string_view formula, const Part& part) const;

    std::vector<const std::vector<Step>*> lists_;
};

/// Number of digits for display.
inline constexpr int readable_digits = 6;

/// A number with at most `digits` digits; "∞" for infinity.
std::string number_text(float x, int digits);

/// What the positions are relative to, as a sentence; empty if that is zero.
std::string origin_text(const Explanation& explanation);

} // namespace glint::formats
