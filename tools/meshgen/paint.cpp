// Vertex colours.

#include "math/trig.h"
#include "shapes.h"

#include <cstddef>
#include <iterator>

namespace glint::meshgen {

void paint(Mesh& mesh, const std::function<dvec3(std::size_t, const dvec3&)>& color) {
    mesh.colors.clear();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.colors.emplace_back(color(i, dvec3(mesh.positions[i])));
    }
}

dvec3 rainbow(double turn) {
    // Squared, as linear light looks paler.
    const auto channel = [turn](double shift) {
        const double c = 0.52 + 0.45 * cos_degrees(360 * (turn - shift));
        return c * c;
    };
    return dvec3(channel(0), channel(1.0 / 3), channel(2.0 / 3));
}

dvec3 landscape(double height) {
    struct Stop {
        double height;
        dvec3 color;
    };
    static constexpr Stop stops[] = {{0.000, {0.03, 0.14, 0.25}}, {0.002, {0.62, 0.50, 0.30}},
                                     {0.050, {0.50, 0.40, 0.20}}, {0.090, {0.10, 0.24, 0.06}},
                                     {0.400, {0.07, 0.16, 0.05}}, {0.600, {0.22, 0.18, 0.15}},
                                     {0.780, {0.30, 0.27, 0.25}}, {0.860, {0.85, 0.87, 0.90}}};
    const Stop& last = *std::rbegin(stops);
    if (height <= 0) return stops[0].color;
    if (height >= last.height) return last.color;
    // By index: sanitizers of g++ 12 reject the pointer before the one found.
    std::size_t above = 1;
    while (stops[above].height <= height) ++above;
    const Stop& from = stops[above - 1];
    const Stop& to = stops[above];
    const double t = (height - from.height) / (to.height - from.height);
    return from.color * (1 - t) + to.color * t;
}

} // namespace glint::meshgen
