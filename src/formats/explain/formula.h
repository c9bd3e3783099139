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
    /// The step's formula with its numbers for its symbols; empty where that says nothing new.
    std::string filled_in(const Step& step) const;

  private:
    const Step* find(std::string_view symbol) const;
    /// Calls part(text, step): step is null for what is no symbol.
    template <class Part>
    void split(std::string_view formula, const Part& part) const;

    std::vector<const std::vector<Step>*> lists_;
};

/// How many digits are for reading.
inline constexpr int readable_digits = 6;

/// A number with so many digits, as short as it can be; "∞" where it is infinite.
std::string number_text(float x, int digits);

} // namespace glint
