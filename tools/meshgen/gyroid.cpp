// Zero surfaces of functions by marching tetrahedra (Doi and Koide, "An efficient method of triangulating
// equi-valued surfaces by using tetrahedral cells", 1991) on Freudenthal's division of the cube into six
// tetrahedra, whose faces match between cubes, so the surface has no cracks.

#include "math/trig.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace glint::meshgen {
namespace {

using Index = std::uint32_t;

// Corners of a cube by bits: 1 is +x, 2 is +y, 4 is +z. Each tetrahedron is a path from corner 0 to 7 along
// one axis at a time.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marcher {
  public:
    Marcher(const std::function<double(const dvec3&)>& value, double size, int cells)
        : size_(size), cells_(cells), row_(static_cast<std::size_t>(cells) + 1) {
        values_.reserve(row_ * row_ * row_);
        for (std::size_t n = 0; n < row_ * row_ * row_; ++n) values_.push_back(value(position(n)));
    }

    Mesh run() {
        for (std::size_t z = 0; z + 1 < row_; ++z) {
            for (std::size_t y = 0; y + 1 < row_; ++y) {
                for (std::size_t x = 0; x + 1 < row_; ++x) march_cube((z * row_ + y) * row_ + x);
            }
        }
        for (const dvec3& p : points_) mesh_.positions.emplace_back(p);
        return std::move(mesh_);
    }

  private:
    dvec3 position(std::size_t n) const {
        const dvec3 steps(static_cast<double>(n % row_), static_cast<double>(n / row_ % row_),
                          static_cast<double>(n / row_ / row_));
        return steps * (2 * size_ / cells_) - size_;
    }

    void march_cube(std::size_t origin) {
        for (const auto& corners : tetrahedra) {
            std::array<std::size_t, 4> node{};
            for (std::size_t i = 0; i < 4; ++i) {
                const unsigned c = corners[i];
                node[i] = origin + (c & 1u) + (c >> 1 & 1u) * row_ + (c >> 2 & 1u) * row_ * row_;
            }
            march_tetrahedron(node);
        }
    }

    void march_tetrahedron(const std::array<std::size_t, 4>& nodes) {
        std::array<std::size_t, 4> in{};
        std::array<std::size_t, 4> out{};
        std::size_t inside = 0;
        std::size_t outside = 0;
        for (const std::size_t n : nodes) (values_[n] < 0 ? in[inside++] : out[outside++]) = n;
        if (inside == 0 || outside == 0) return;

        // Evaluate in an initializer list, which is ordered unlike function arguments: vertices are numbered
        // as they are created.
        const dvec3 outward = position(out[0]) - position(in[0]);
        if (inside == 2) {
            const std::array<Index, 4> ring{cut(in[0], out[0]), cut(in[0], out[1]), cut(in[1], out[1]),
                                            cut(in[1], out[0])};
            add_triangle({ring[0], ring[1], ring[2]}, outward);
            add_triangle({ring[0], ring[2], ring[3]}, outward);
        } else if (inside == 1) {
            add_triangle({cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2])}, outward);
        } else {
            add_triangle({cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0])}, outward);
        }
    }

    // The corners of every triangle separate in[0] from out[0], so the sign is certain.
    void add_triangle(std::array<Index, 3> t, const dvec3& outward) {
        const dvec3 normal = glm::cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
        if (glm::dot(normal, outward) < 0) std::swap(t[1], t[2]);
        mesh_.triangles.emplace_back(t[0], t[1], t[2]);
    }

    // The vertex on the edge between an inside and an outside node, created once for all tetrahedra that
    // share it.
    Index cut(std::size_t in, std::size_t out) {
        const std::uint64_t edge = static_cast<std::uint64_t>(std::min(in, out)) << 32 | std::max(in, out);
        const auto [it, is_new] = made_.try_emplace(edge, static_cast<Index>(points_.size()));
        if (is_new) {
            // Keep off the nodes, where triangles would degenerate.
            const double t = std::clamp(values_[in] / (values_[in] - values_[out]), 0.02, 0.98);
            points_.push_back(position(in) * (1 - t) + position(out) * t);
        }
        return it->second;
    }

    double size_;
    int cells_;
    std::size_t row_;
    std::vector<double> values_;
    std::vector<dvec3> points_;
    std::unordered_map<std::uint64_t, Index> made_;
    Mesh mesh_;
};

// Maximum of two values, smoothed where they differ by less than k.
double smooth_max(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0);
    return std::max(a, b) + h * h / (4 * k);
}

} // namespace

Mesh march_tetrahedra(const std::function<double(const dvec3&)>& value, double size, int cells) {
    return Marcher(value, size, cells).run();
}

Mesh make_gyroid(int cells, double periods, double thickness) {
    const double frequency = 180 * periods; // degrees per unit of length
    const auto value = [&](const dvec3& p) {
        // Shift by an eighth of a period, so that the centre of the ball is empty.
        const dvec3 a = p * frequency + 45.0;
        const double wave = sin_degrees(a.x) * cos_degrees(a.y) + sin_degrees(a.y) * cos_degrees(a.z) +
                            sin_degrees(a.z) * cos_degrees(a.x);
        // Near the surface |wave| grows by about 1.2 · frequency (in radians) per unit of length.
        const double sheet = std::abs(wave) / (1.2 * frequency * 3.14159265358979 / 180) - thickness / 2;
        return smooth_max(sheet, glm::length(p) - 1, thickness);
    };
    return march_tetrahedra(value, 1.05, cells);
}

} // namespace glint::meshgen
