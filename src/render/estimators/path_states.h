#pragma once
// The paths of a wavefront as a structure of arrays: what belongs to path i is element i of every row, so
// that vectors of paths can be shaded at once (render/shade_batch.h).

#include "render/camera_sample.h"
#include "render/contact.h"
#include "render/interior_list.h"
#include "scene/scene_data.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace glint::rendering {

inline constexpr std::size_t shading_numbers = [] {
    std::size_t count = 0;
    const MaterialRecord m{};
    for_shading_numbers(m, [&](float) { ++count; });
    return count;
}();

struct PathStates {
    /// For the waves of all depths. Where little room is left, branches are followed by recursion.
    static constexpr std::size_t capacity = 4096;
    static constexpr std::size_t max_wave = 256;
    /// Waves begin at a multiple of this. No vector has more lanes.
    static constexpr std::size_t alignment = 16;

    /// Elements behind the last path, for the last vector to touch. The odd size also keeps rows from
    /// beginning at equal offsets of pages, where processors take a load from one row to depend on a store to
    /// another.
    static constexpr std::size_t padding = 72;
    static_assert(padding >= alignment);

    template <class T>
    using Row = std::array<T, capacity + padding>;
    using Numbers = Row<float>;
    using Vectors = std::array<Numbers, 3>; ///< x, y, z

    Row<Ray> rays;
    Row<trace::Hit> hits;
    Row<const InteriorList*> interiors;   ///< around the ray's origin, then where it arrives
    Row<Contact> contacts;                ///< where it arrives; set only where there may be any
    Row<const MaterialRecord*> materials; ///< never null
    Row<std::uint32_t> parents;           ///< the path that this is a branch of
    Row<Term> parent_terms;               ///< the term of the parent that it adds to
    Vectors parent_weights;               ///< its share there
    Vectors weights;                      ///< the share of the path's light that reaches its sample
    Vectors left_over; ///< of light behind the medium; for paths in solids that hit something
    std::array<Vectors, term_count> terms;
    Vectors sums; ///< of the terms

    // The surface: p, p_error, n as in SurfacePoint, then toward the viewer as in SurfaceRecord.
    Row<std::uint8_t> located; ///< by World::surfaces(), else by surface_interaction()
    Vectors p, p_error, n_g, n, v, color;
    Numbers entering; ///< 1 or 0
    Numbers lit_side;
    std::array<Numbers, shading_numbers> material_numbers; ///< as for_shading_numbers() lists them

    // One light: its direction, what arrives before shadows (0 where no shadow ray is sent), the shadow ray,
    // whether that is blocked, and the share of blocked light that passes all the same.
    Vectors to_light, arriving;
    Row<Ray> shadow_rays;
    Row<std::uint8_t> blocked;
    Vectors passing;
};

/// Paths first … first + count − 1: those of one depth.
struct Wave {
    std::size_t first = 0;
    std::size_t count = 0;

    /// Index of the first path of the next wave.
    std::size_t end() const {
        return (first + count + PathStates::alignment - 1) / PathStates::alignment * PathStates::alignment;
    }
};

} // namespace glint::rendering
