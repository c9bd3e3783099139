#pragma once
// What rough surfaces keep of their light where each ray meets one facet alone, as a table. It is in the
// source (microfacet_energy.inc), since integrating it takes seconds; tests/shading/energy_test.cpp writes
// it.

#include <array>
#include <cstddef>

namespace glint::shading {

/// E: the share of light that leaves a surface of microfacets without losses, seen under `cosine` (0 … 1),
/// without the light that further facets would scatter. `eta` is the index behind the surface / the one in
/// front of it; 0: a metal. Within 0.003 for cosines above 0.05 and eta 0.25 … 4, beyond which it is that of
/// the nearest.
float microfacet_energy(float cosine, float alpha, float eta);

/// The share of light that sheen_value() reflects, seen under `cosine`.
float sheen_energy(float cosine, float alpha);

/// The nodes of the table: planes of rows of one roughness, in them by cosine.
namespace energy_table {

inline constexpr std::size_t cosines = 24;
inline constexpr std::size_t roughnesses = 24;
inline constexpr std::size_t below_1 = 24; ///< of `indices`, those where light leaves a dense medium
inline constexpr std::size_t indices = below_1 + 9;
inline constexpr std::size_t metal = indices; ///< the plane behind those of `indices`
inline constexpr std::size_t sheen = metal + 1;
inline constexpr std::size_t planes = sheen + 1;
inline constexpr float scale = 10000;

using Plane = std::array<std::array<short, cosines>, roughnesses>; ///< in units of 1/scale

/// The numbers that belong to a node.
float alpha_at(std::size_t roughness);
float cosine_at(std::size_t cosine, float alpha);
float eta_at(std::size_t index); ///< 0 for the plane of metal

const std::array<Plane, planes>& values();

} // namespace energy_table

} // namespace glint::shading
