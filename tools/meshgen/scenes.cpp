// Sphere flake and city.

#include "scenes.h"

#include "math/random.shared.h"
#include "math/trig.h"
#include "math/vec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace glint::meshgen {
namespace {

constexpr const char* flake_head =
    R"(# A sphere flake: every ball carries nine of a third of its size, three times over.
# Made by `glint-meshgen flake`. After Haines' "balls" of 1987.

version = 1

[camera]
eye = [2.5, -5.6, 2.2]
look_at = [0.05, 0, 0.22]
fov = 31

[render]
size = [960, 640]
spp = 16
background = [0.02, 0.03, 0.06]

[whitted]
max_depth = 6

[material.floor]
color = [0.05, 0.07, 0.12]
diffuse = 0.9
reflectivity = 0.3

[[plane]]
normal = [0, 0, 1]
offset = -1.02
material = "floor"

[[light]]
type = "ambient"
color = [0.07, 0.08, 0.11]

[[light]]
type = "point" # warm, over the left shoulder
position = [-5, -7, 8]
color = [1, 0.90, 0.76]
intensity = 130

[[light]]
type = "point" # cool, from the right
position = [8, -1, 3]
color = [0.50, 0.66, 1]
intensity = 42

[[light]]
type = "point" # a rim of light from behind
position = [-3, 7, 5]
color = [1, 0.62, 0.40]
intensity = 55
)";

// One material a level; the last is used for all deeper ones.
constexpr const char* flake_colors[] = {"0.34, 0.06, 0.04", "0.52, 0.20, 0.05", "0.60, 0.40, 0.10",
                                        "0.20, 0.38, 0.34", "0.62, 0.60, 0.54"};

std::string flake_materials(int levels) {
    std::string text;
    for (int level = 0; level <= levels; ++level) {
        const auto row = std::min<std::size_t>(static_cast<std::size_t>(level), std::size(flake_colors) - 1);
        text += fmt::format(
            "\n[material.level{}]\ncolor = [{}]\ndiffuse = 0.6\nhighlight = 0.35\nshininess = 90\n"
            "reflectivity = {}\n",
            level, flake_colors[row], level == 0 ? 0.5 : 0.35);
    }
    return text;
}

void add_balls(std::string& text, const dvec3& center, double radius, const dvec3& axis, int level,
               int levels) {
    text += fmt::format(
        "\n[[sphere]]\ncenter = [{:.4f}, {:.4f}, {:.4f}]\nradius = {:.5f}\nmaterial = \"level{}\"\n",
        center.x, center.y, center.z, radius, level);
    if (level == levels) return;

    // Six around the equator and three above, relative to the attachment point.
    const dvec3 aside =
        glm::normalize(std::abs(axis.z) > 0.9 ? dvec3(1, 0, 0) : glm::cross(axis, dvec3(0, 0, 1)));
    const dvec3 u = glm::normalize(aside - glm::dot(aside, axis) * axis);
    const dvec3 v = glm::cross(axis, u);
    for (int k = 0; k < 9; ++k) {
        const double turn = k < 6 ? 60.0 * k + 15 : 120.0 * k + 45;
        const double lift = k < 6 ? 0 : 55;
        const dvec3 out =
            (u * cos_degrees(turn) + v * sin_degrees(turn)) * cos_degrees(lift) + axis * sin_degrees(lift);
        add_balls(text, center + out * (radius * 4 / 3), radius / 3, out, level + 1, levels);
    }
}

constexpr const char* city_head = R"(# A city of cylinders at dusk, on the water.
# Made by `glint-meshgen city`.

version = 1

[camera]
eye = [-15, -26, 3.1]
look_at = [0, 0, 1.75]
fov = 25

[render]
size = [960, 640]
spp = 16
background = [0.10, 0.09, 0.16]

[whitted]
max_depth = 4

[material.water]
color = [0.02, 0.04, 0.07]
reflectivity = 0.6

[material.sky]
color = [0.86, 0.80, 0.84]
diffuse = 0.95

[material.sun]
diffuse = 0
ambient = 0
emission = [1, 0.80, 0.45]

[material.quay]
color = [0.30, 0.27, 0.27]

[material.lamp]
color = [1, 0.8, 0.5]
diffuse = 0
emission = [1.2, 0.75, 0.32]

[material.stone]
color = [0.60, 0.50, 0.44]

[material.brick]
color = [0.50, 0.20, 0.13]

[material.slate]
color = [0.20, 0.23, 0.30]

[material.copper]
color = [0.18, 0.36, 0.32]

[material.glass]
color = [0.14, 0.18, 0.25]
diffuse = 0.6
highlight = 0.3
shininess = 60
reflectivity = 0.4

[[plane]]
normal = [0, 0, 1]
offset = -0.15
material = "water"

[[plane]] # the sky is a wall behind the city, lit from where the sun sets
normal = [-0.5, -0.866, 0]
offset = -80
material = "sky"

[[sphere]]
center = [34.4, 75.6, 5.5]
radius = 4
material = "sun"

[[light]]
type = "point"
position = [25, 47, 1]
color = [1, 0.42, 0.16]
intensity = 560

[[cylinder]]
base = [0, 0, -1]
height = 1
radius = 8.8
material = "quay"

[[light]]
type = "ambient"
color = [0.10, 0.10, 0.17]

[[light]]
type = "directional" # the sun, low behind the city
direction = [0.85, -0.5, -0.26]
color = [1, 0.55, 0.25]
irradiance = 1.9

[[light]]
type = "directional" # what the sky gives from the other side
direction = [-0.3, 0.8, -0.7]
color = [0.35, 0.42, 0.70]
irradiance = 0.28
)";

std::string cylinder(const dvec3& base, double height, double radius, const char* material) {
    return fmt::format("\n[[cylinder]]\nbase = [{:.3f}, {:.3f}, {:.3f}]\nheight = {:.3f}\nradius = {:.3f}\n"
                       "material = \"{}\"\n",
                       base.x, base.y, base.z, height, radius, material);
}

double chance(unsigned number, unsigned draw) {
    return static_cast<double>(unit_float(hash_with(hash_mix(number), draw)));
}

// A tower of one to three drums of decreasing width, some with a lamp on top.
std::string tower(const dvec3& at, double height, double radius, unsigned number) {
    constexpr const char* materials[] = {"stone", "brick", "slate", "copper", "glass", "stone", "glass"};
    const char* material = materials[static_cast<std::size_t>(chance(number, 1) * 7)];
    std::string text;
    dvec3 base = at;
    const int drums = height > 2 ? 3 : height > 1 ? 2 : 1;
    for (int drum = 0; drum < drums; ++drum) {
        const double part = height * (drums == 1 ? 1 : drum == 0 ? 0.62 : 0.38 / (drums - 1));
        text += cylinder(base, part, radius, material);
        base.z += part;
        radius *= 0.68;
    }
    if (height > 2.2 || chance(number, 2) < 0.12) text += cylinder(base, 0.1, radius * 0.7, "lamp");
    return text;
}

} // namespace

std::string sphere_flake_scene(int levels) {
    std::string text = flake_head + flake_materials(levels);
    add_balls(text, dvec3(0), 1, dvec3(0, 0, 1), 0, levels);
    return text;
}

std::string city_scene(int rings) {
    // Towers on concentric rings, the highest in the centre.
    std::string text = city_head;
    unsigned number = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const double far = 8.2 * (ring + 0.4) / rings;
        const int count = std::max(1, static_cast<int>(6.2832 * far / 0.98));
        for (int k = 0; k < count; ++k, ++number) {
            const double turn = 360 * (k + 0.5 * chance(number, 3)) / count;
            const dvec3 at(far * cos_degrees(turn), far * sin_degrees(turn), 0);
            const double bulk = 1 - far / 9;
            const double height = 0.35 + (0.3 + chance(number, 4)) * 4.6 * bulk * bulk;
            text += tower(at, height, 0.24 + 0.17 * chance(number, 5), number);
        }
    }
    return text;
}

} // namespace glint::meshgen
