#pragma once
// The terms of the light model that a picture is the sum of.

#include <cstddef>

namespace glint {

/// The terms of the first hit and the branches below it, in the order in which they add up to the picture.
enum class Term { ambient, diffuse, highlight, clamp, reflection, transmission, emission };
inline constexpr int term_count = 7;

/// "ambient", "diffuse", …
inline const char* term_name(Term term) {
    static constexpr const char* names[term_count] = {"ambient",    "diffuse",      "highlight", "clamp",
                                                      "reflection", "transmission", "emission"};
    return names[static_cast<std::size_t>(term)];
}

} // namespace glint
