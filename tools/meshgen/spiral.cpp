// The sunflower scene.

#include "scenes.h"

#include "math/trig.h"
#include "math/vec.h"

#include <fmt/format.h>

#include <cmath>

namespace glint::meshgen {
namespace {

constexpr const char* head =
    R"(# A flower of shells: one mesh of 120,000 triangles shown {0} times, {1} million triangles in the room of one.
# Made by `glint-meshgen spiral`. Each turns 137.5 degrees further than the one before it, as the seeds of a
# sunflower do (H. Vogel, "A better way to construct the sunflower head", 1979).

version = 1

[camera]
eye = [0, -15.2, 11.6]
look_at = [0, -0.5, 0.2]
fov = 34

[render]
size = [960, 640]
spp = 16
background = [0.02, 0.03, 0.05]

[whitted]
max_depth = 3

[material.shell0]
color = [0.62, 0.09, 0.10]
highlight = 0.35
shininess = 60

[material.shell1]
color = [0.78, 0.30, 0.08]
highlight = 0.35
shininess = 60

[material.shell2]
color = [0.80, 0.58, 0.22]
highlight = 0.35
shininess = 60

[material.shell3]
color = [0.82, 0.76, 0.64]
highlight = 0.35
shininess = 60

[material.pearl]
color = [0.9, 0.88, 0.84]
diffuse = 0.5
highlight = 0.6
shininess = 150
reflectivity = 0.35

[material.water]
color = [0.03, 0.07, 0.10]
highlight = 0.4
shininess = 200
reflectivity = 0.35

[[plane]]
normal = [0, 0, 1]
offset = -0.35
material = "water"

[[sphere]]
center = [0, 0, 1.5]
radius = 0.75
material = "pearl"

[[light]]
type = "ambient"
color = [0.10, 0.11, 0.14]

[[light]]
type = "point" # warm, from the left
position = [-12, -8, 14]
color = [1, 0.82, 0.60]
intensity = 420

[[light]]
type = "point" # cool, from behind
position = [9, 12, 9]
color = [0.55, 0.70, 1]
intensity = 190

[[mesh]]
name = "shell"
file = "meshes/shell.ply" # missing? `scripts/gallery --meshes` makes it
material = "shell0"
vertex_colors = "ignore"
visible = false # only its instances are shown
)";

} // namespace

std::string spiral_scene(int count) {
    constexpr double golden_angle = 137.50776405003785;
    constexpr double triangles = 120048;
    std::string text = fmt::format(head, count, std::lround(count * triangles / 1e6));
    // Colours by index modulo 21, a Fibonacci number, so that spiral arms have one colour. From the centre of
    // a dome outward, shells grow and tilt.
    const double spread = 6.6 / std::sqrt(static_cast<double>(count));
    for (int k = 0; k < count; ++k) {
        const double far = 0.9 + spread * std::sqrt(k + 0.5);
        const double out = far / 7.5;
        const double turn = golden_angle * k;
        const double size = (3.4 + 3.0 * out) * spread / 1.75;
        text += fmt::format("\n[[instance]]\nmesh = \"shell\"\nmaterial = \"shell{}\"\ntransform = [{{ scale "
                            "= {:.4f} }}, {{ rotate "
                            "= [0, 1, 0], angle = "
                            "{:.2f} }}, {{ rotate = [0, 0, 1], angle = {:.2f} }}, {{ translate = [{:.4f}, "
                            "{:.4f}, {:.4f}] }}]\n",
                            k % 21 * 4 / 21, size, 10 + 75 * out, std::fmod(turn, 360.0),
                            far * cos_degrees(turn), far * sin_degrees(turn), 1.5 * (1 - out * out));
    }
    return text;
}

} // namespace glint::meshgen
