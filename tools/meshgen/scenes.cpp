// Sphere flake, city and sunflower.

#include "scenes.h"

#include "embedded.h"

#include "math/random.shared.h"
#include "math/trig.h"
#include "math/vec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace glint::meshgen {
namespace {

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
    std::string text = embedded_texts[flake_head].text + flake_materials(levels);
    add_balls(text, dvec3(0), 1, dvec3(0, 0, 1), 0, levels);
    return text;
}

std::string city_scene(int rings) {
    // Towers on concentric rings, the highest in the centre.
    std::string text = embedded_texts[city_head].text;
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

std::string spiral_scene(int count) {
    constexpr double golden_angle = 137.50776405003785;
    constexpr double triangles = 120048;
    std::string text = fmt::format(fmt::runtime(embedded_texts[spiral_head].text), count,
                                   std::lround(count * triangles / 1e6));
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
