#pragma once
// Rays of a batch on their way, in rows: what belongs to flight i stands at place i of every row, so that
// vectors of flights can be shaded at once (shade_batch.h).

#include "render/ray_tree.h"
#include "scene/frozen.h"
#include "scene/media.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace glint {

struct Flights {
    /// Ray trees grow without end where glass meets glass: what has no room here is followed by recursion.
    static constexpr std::size_t most = 4096;
    /// Flights of one level begin at a multiple of this, which no vector is longer than.
    static constexpr std::size_t step = 16;

    /// Behind the last flight: what the last vector may touch. And rows shall not begin at one place of a
    /// page, where processors take a load from one row to wait for the store to another.
    static constexpr std::size_t gap = 72;
    static_assert(gap >= step);

    template <class T>
    using Row = std::array<T, most + gap>;
    using Numbers = Row<float>;
    using Vectors = std::array<Numbers, 3>; ///< x, y, z

    Row<Ray> rays;
    Row<Hit> hits;
    Row<const Media*> media;              ///< the solids around the ray's origin
    Row<const MaterialRecord*> materials; ///< never null
    Row<std::uint32_t> parents;           ///< the flight that this one is a branch of
    Row<Term> branches;                   ///< what it brings its parent
    Numbers weights;                      ///< what its light counts there
    std::array<Vectors, term_count> terms;
    Vectors sums; ///< of the terms

    // The surface: p, p_error, n as in SurfacePoint, then turned to the viewer as in WhittedTracer::Surface.
    Vectors p, p_error, n_g, n, v, color;
    Numbers entering; ///< 1 or 0
    Numbers lit_side, diffuse, highlight, shininess, reflectivity, transparency;

    // One light: the way to it, what arrives before shadows (0 where no shadow ray is sent), the shadow ray,
    // what that met, and the share of blocked light that gets through all the same.
    Vectors to_light, arriving;
    Row<Ray> shadow_rays;
    Row<std::uint8_t> blocked;
    Numbers through;
};

/// Flights first … first + count − 1: those that have bounced equally often.
struct Level {
    std::size_t first = 0;
    std::size_t count = 0;

    /// Where the next one begins.
    std::size_t end() const { return (first + count + Flights::step - 1) / Flights::step * Flights::step; }
};

} // namespace glint
