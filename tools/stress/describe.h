#pragma once
// Lossless descriptions of rays and hits.

#include "trace/world/world.h"

#include <cstdio>
#include <string>

namespace glint::stress {

/// All numbers of a ray as hexadecimal floats.
inline std::string describe(const Ray& ray) {
    char text[320];
    std::snprintf(text, sizeof text, "origin (%a %a %a) direction (%a %a %a) tmin %a tmax %a",
                  double(ray.origin.x), double(ray.origin.y), double(ray.origin.z), double(ray.direction.x),
                  double(ray.direction.y), double(ray.direction.z), double(ray.tmin), double(ray.tmax));
    return text;
}

inline std::string describe(const trace::Hit& hit) {
    if (!hit) return "nothing";
    char text[160];
    std::snprintf(text, sizeof text, "t %a u %a v %a object %u prim %u kind %d%s", double(hit.t),
                  double(hit.u), double(hit.v), hit.object, hit.prim, static_cast<int>(hit.kind),
                  hit.on_edge ? " on an edge" : "");
    return text;
}

} // namespace glint::stress
