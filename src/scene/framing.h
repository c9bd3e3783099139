#pragma once
// Cameras that see all of something, as near as they can stand.

#include "glint/scene.h"
#include "math/vec.h"

#include <functional>

namespace glint {

/// Orthonormal axes of a camera.
struct ViewAxes {
    dvec3 right{1, 0, 0};
    dvec3 up{0, 0, 1};
    dvec3 forward{0, 1, 0};
};

/// From the front (−y), turned by `azimuth` degrees to the left and raised by `elevation`, looking down; z is
/// up.
ViewAxes three_quarter_view(double azimuth, double elevation);

inline constexpr double default_azimuth = 28;   // degrees
inline constexpr double default_elevation = 20; // degrees

struct Lens {
    double fov = 40;    ///< full angle in y, degrees
    double aov = 1;     ///< width / height
    double fill = 0.85; ///< share of the picture that may be filled
};

/// d ↦ the largest d · p over all points p of what is to be seen.
using SupportFunction = std::function<double(const dvec3&)>;

/// The nearest camera with these axes that sees everything within the middle `fill` of the picture.
CameraDescription fit_camera(const ViewAxes& view, const Lens& lens, const SupportFunction& reach);

} // namespace glint
