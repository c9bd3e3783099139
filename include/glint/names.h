#pragma once
// The names of enumerators, shapes and lights as scene files write them: one table each.

#include "glint/scene.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>

namespace glint {

/// As many names as an enumeration has values, of which `last` is the last.
template <auto last>
using NamesUpTo = std::array<std::string_view, static_cast<std::size_t>(last) + 1>;

/// The names of an enumeration's values, in their order.
template <class Enum>
inline constexpr bool enum_names = false;

template <>
inline constexpr NamesUpTo<FovAxis::larger> enum_names<FovAxis>{"y", "x", "smaller", "larger"};
template <>
inline constexpr NamesUpTo<PixelFilter::mitchell> enum_names<PixelFilter>{"box", "tent", "gaussian",
                                                                          "mitchell"};
template <>
inline constexpr NamesUpTo<Integrator::whitted> enum_names<Integrator>{"whitted"};
template <>
inline constexpr NamesUpTo<Shadows::opaque> enum_names<Shadows>{"transmissive", "opaque"};
template <>
inline constexpr NamesUpTo<Energy::balanced> enum_names<Energy>{"report", "balanced"};
template <>
inline constexpr NamesUpTo<HighlightModel::phong> enum_names<HighlightModel>{"blinn", "phong"};
template <>
inline constexpr NamesUpTo<PolyhedronKind::pyramid> enum_names<PolyhedronKind>{
    "box", "tetrahedron", "octahedron", "dodecahedron", "icosahedron", "prism", "pyramid"};
template <>
inline constexpr NamesUpTo<NormalsMode::smooth> enum_names<NormalsMode>{"auto", "flat", "smooth"};
template <>
inline constexpr NamesUpTo<Facing::stored> enum_names<Facing>{"viewer", "stored"};
template <>
inline constexpr NamesUpTo<VertexColors::ignore> enum_names<VertexColors>{"auto", "ignore"};

/// The tables of objects: [[plane]], [[sphere]], …
inline constexpr std::array<std::string_view, std::variant_size_v<Shape>> shape_names{
    "plane", "sphere", "cylinder", "cone", "disk", "triangle", "rectangle", "polyhedron", "mesh", "instance"};
static_assert(!shape_names.back().empty(), "a shape has no name");

/// Several of them, in prose.
inline constexpr std::array<std::string_view, std::variant_size_v<Shape>> shape_plurals{
    "planes",    "spheres",    "cylinders", "cones",  "disks",
    "triangles", "rectangles", "polyhedra", "meshes", "instances"};
static_assert(!shape_plurals.back().empty(), "a shape has no plural");

/// The types of [[light]].
inline constexpr std::array<std::string_view, std::variant_size_v<decltype(Light::kind)>> light_names{
    "ambient", "point", "directional", "spot"};
static_assert(!light_names.back().empty(), "a light has no name");

template <class Enum>
constexpr std::string_view name_of(Enum value) {
    return enum_names<Enum>[static_cast<std::size_t>(value)];
}
constexpr std::string_view name_of(const Shape& shape) { return shape_names[shape.index()]; }
constexpr std::string_view name_of(const Light& light) { return light_names[light.kind.index()]; }

/// The value of that name; none if there is none.
template <class Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
    for (std::size_t i = 0; i < enum_names<Enum>.size(); ++i)
        if (enum_names<Enum>[i] == name) return static_cast<Enum>(i);
    return std::nullopt;
}

} // namespace glint
