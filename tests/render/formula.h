#pragma once
// A reader of the formulas of explanations: what an outsider would write who has docs/explain.md only.

#include <glm/vec3.hpp>

#include <map>
#include <string>

namespace glint::test {

struct Number {
    glm::vec3 v{0.0f};
    bool vector = false;
};

/// The value of a formula in single precision; throws std::runtime_error for what it does not understand.
Number evaluate(const std::string& formula, const std::map<std::string, Number>& values);

} // namespace glint::test
