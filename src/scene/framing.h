#pragma once
// Cameras that show a set of points as large as possible.

#include "glint/scene.h"
#include "math/vec.h"

#include <functional>

namespace glint::scene {

/// Orthonormal axes of a camera.
struct ViewAxes {
    dvec3 right{1, 0, 0};
    dvec3 up{0, 0, 1};
    dvec3 forward{0, 1, 0};
};

/// View from the front (−y), rotated by `azimuth` degrees to the left and raised by `elevation`, looking
/// down; z is up.
ViewAxes three_quarter_view(double azimuth, double elevation);

inline constexpr double default_azimuth = 28;   // degrees
inline constexpr double default_elevation = 20; // degrees

struct Lens {
    double fov = 40;    ///< full angle in y, degrees
    double aov = 1;     ///< width / height
    double fill = 0.85; ///< fraction of the picture that may be filled
};

/// Support function: d ↦ max d · p over the points p to show.
using SupportFunction = std::function<double(const dvec3&)>;

/// The nearest camera with these axes that shows everything within the central fraction `fill` of the
/// picture.
CameraDescription fit_camera(const ViewAxes& view, const Lens& lens, const SupportFunction& reach);

} // namespace glint::scene
