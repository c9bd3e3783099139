#pragma once
// The gain of a material.

#include <algorithm>

namespace glint::shading {

/// The light that can leave a surface for each light that arrives: w max(c) k_d + ρ + τ, w as local_weight().
/// Above 1 more leaves than arrives. `brightest` is the colour's largest channel.
template <class Real>
Real light_gain(Real brightest, Real k_d, Real reflectivity, Real transparency, bool balanced) {
    const Real kept = Real(1) - transparency;
    const Real weight = balanced ? std::max(Real(0), kept - reflectivity) : kept;
    return weight * brightest * k_d + reflectivity + transparency;
}

} // namespace glint::shading
