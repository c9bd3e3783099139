// Terrain by ridged noise.

#include "math/random.shared.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace glint::meshgen {
namespace {

double lattice(unsigned seed, int x, int y) {
    const unsigned h =
        hash_with(hash_with(hash_mix(seed), static_cast<unsigned>(x)), static_cast<unsigned>(y));
    return static_cast<double>(unit_float(h));
}

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// Value noise in 0 … 1 with a random height at every lattice point.
double value_noise(unsigned seed, double x, double y) {
    const double fx = std::floor(x);
    const double fy = std::floor(y);
    const int ix = static_cast<int>(fx);
    const int iy = static_cast<int>(fy);
    const double u = fade(x - fx);
    const double v = fade(y - fy);
    const double low = lattice(seed, ix, iy) * (1 - u) + lattice(seed, ix + 1, iy) * u;
    const double high = lattice(seed, ix, iy + 1) * (1 - u) + lattice(seed, ix + 1, iy + 1) * u;
    return low * (1 - v) + high * v;
}

// Ridged noise: octaves folded at their middle, each rotated against the one before to hide the lattice.
double ridged_noise(unsigned seed, double x, double y) {
    double sum = 0;
    double weight = 0.5;
    for (unsigned octave = 0; octave < 9; ++octave) {
        const double fold = 1 - std::abs(2 * value_noise(seed + octave, x, y) - 1);
        sum += weight * fold * fold;
        weight *= 0.47;
        const double turned = 1.6 * x - 1.2 * y + 17;
        y = 1.2 * x + 1.6 * y + 29;
        x = turned;
    }
    return sum;
}

// Height above sea level; the border is lower, so that the land is an island.
double height_at(unsigned seed, double x, double y) {
    const double rim = std::max(0.0, 1 - (x * x + y * y) * 0.85);
    return std::max(0.0,
                    (ridged_noise(seed, 1.7 * x + 8, 1.7 * y + 8) * (0.25 + 0.75 * rim) * rim - 0.16) * 0.95);
}

} // namespace

Mesh make_terrain(int steps, unsigned seed) {
    Mesh mesh;
    const auto at = [steps](int i) { return 2.0 * i / steps - 1; };
    for (int j = 0; j <= steps; ++j) {
        for (int i = 0; i <= steps; ++i) {
            mesh.positions.emplace_back(dvec3(at(i), at(j), height_at(seed, at(i), at(j))));
        }
    }
    const unsigned row = static_cast<unsigned>(steps) + 1;
    for (unsigned j = 0; j + 1 < row; ++j) {
        for (unsigned i = 0; i + 1 < row; ++i) {
            const unsigned a = j * row + i;
            mesh.triangles.emplace_back(a, a + 1, a + row + 1);
            mesh.triangles.emplace_back(a, a + row + 1, a + row);
        }
    }
    return mesh;
}

} // namespace glint::meshgen
