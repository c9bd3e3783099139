#pragma once
// The terms of light that a picture is the sum of: as many for each integrator that splits light.

#include "glint/enum_names.h"

namespace glint {

/// The terms of Whitted's model: those of the first hit and the branches below it, in the order in which they
/// add up to the picture.
enum class Term { ambient, diffuse, highlight, clamp, reflection, transmission, emission };
template <>
inline constexpr NamesUpTo<Term::emission> enum_names<Term>{
    "ambient", "diffuse", "highlight", "clamp", "reflection", "transmission", "emission"};
inline constexpr int term_count = enum_names<Term>.size();

/// "ambient", "diffuse", …
inline const char* term_name(Term term) { return name_of(term).data(); }

/// The terms of path tracing, in the order in which they add up to the picture: light that comes to the first
/// hit directly from what emits it, or by further bounces, by how the first hit sends it on; and what emits
/// light there itself, or the background.
enum class PathTerm {
    direct_diffuse,
    direct_specular,
    direct_transmission,
    indirect_diffuse,
    indirect_specular,
    indirect_transmission,
    emission
};
template <>
inline constexpr NamesUpTo<PathTerm::emission> enum_names<PathTerm>{
    "direct-diffuse",   "direct-specular",   "direct-transmission",
    "indirect-diffuse", "indirect-specular", "indirect-transmission",
    "emission"};
static_assert(enum_names<PathTerm>.size() == term_count);

} // namespace glint
