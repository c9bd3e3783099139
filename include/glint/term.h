#pragma once
// The terms of the light model that a picture is the sum of.

#include "glint/enum_names.h"

namespace glint {

/// The terms of the first hit and the branches below it, in the order in which they add up to the picture.
enum class Term { ambient, diffuse, highlight, clamp, reflection, transmission, emission };
template <>
inline constexpr NamesUpTo<Term::emission> enum_names<Term>{
    "ambient", "diffuse", "highlight", "clamp", "reflection", "transmission", "emission"};
inline constexpr int term_count = enum_names<Term>.size();

/// "ambient", "diffuse", …
inline const char* term_name(Term term) { return name_of(term).data(); }

} // namespace glint
