#include "shading/microfacet_energy.h"

#include <algorithm>
#include <cmath>

namespace glint::shading {
namespace energy_table {
namespace {

constexpr float widest = 0.6f; ///< (η − 1)/(η + 1) for η = 4
constexpr float least = 1e-4f; ///< of cosine and alpha: at 0 there are no facets to see

/// A node's coordinate, 0 … 1.
float unit_at(std::size_t i, std::size_t nodes) {
    return static_cast<float>(i) / static_cast<float>(nodes - 1);
}

} // namespace

// E is smooth in √alpha and in cosine / (cosine + alpha): it changes near grazing views, the nearer the
// smoother the surface. Of the root of the reflectance at normal incidence, with its sign, the nodes are
// dense just below 0, where total reflection begins.

float alpha_at(std::size_t roughness) {
    const float r = unit_at(roughness, roughnesses);
    return std::max(least, r * r);
}

float cosine_at(std::size_t cosine, float alpha) {
    const float x = unit_at(cosine, cosines);
    return std::clamp(x * alpha / (1 + alpha - x), least, 1.0f);
}

float eta_at(std::size_t index) {
    if (index >= metal) return 0;
    const bool below = index < below_1;
    const float way = below ? static_cast<float>(below_1 - index) / static_cast<float>(below_1)
                            : static_cast<float>(index - below_1) / static_cast<float>(indices - 1 - below_1);
    const float root = widest * way * way * (below ? -1.0f : 1.0f);
    return (1 + root) / (1 - root);
}

const std::array<Plane, planes>& values() {
    static constexpr std::array<Plane, planes> all{{
#include "shading/microfacet_energy.inc"
    }};
    return all;
}

} // namespace energy_table

namespace {

using namespace energy_table;

/// Between two nodes.
struct Cell {
    std::size_t node;
    float share; ///< of the next node
};

Cell cell_of(float x, std::size_t nodes) {
    const float scaled = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(nodes - 1);
    const std::size_t node = std::min(static_cast<std::size_t>(scaled), nodes - 2);
    return {node, scaled - static_cast<float>(node)};
}

/// Inverse of eta_at(), as a share of all indices.
float index_of(float eta) {
    const float root = (eta - 1) / (eta + 1);
    const float way = std::sqrt(std::abs(root) / widest);
    const float intervals = static_cast<float>(root < 0 ? below_1 : indices - 1 - below_1);
    return (static_cast<float>(below_1) + std::copysign(way, root) * intervals) /
           static_cast<float>(indices - 1);
}

float between(float a, float b, const Cell& cell) { return a + (b - a) * cell.share; }

float value_of(std::size_t plane, float cosine, float alpha) {
    const Cell c = cell_of(cosine * (1 + alpha) / (cosine + alpha), cosines);
    const Cell r = cell_of(std::sqrt(alpha), roughnesses);
    const Plane& rows = values()[plane];
    const auto along = [&](const auto& row) { return between(row[c.node], row[c.node + 1], c); };
    return between(along(rows[r.node]), along(rows[r.node + 1]), r) / scale;
}

} // namespace

float microfacet_energy(float cosine, float alpha, float eta) {
    if (eta == 0) return value_of(metal, cosine, alpha);
    const Cell index = cell_of(index_of(eta), indices);
    return between(value_of(index.node, cosine, alpha), value_of(index.node + 1, cosine, alpha), index);
}

float sheen_energy(float cosine, float alpha) { return value_of(sheen, cosine, alpha); }

} // namespace glint::shading
