// Welding, closedness, volume, degenerate triangles and vertex normals of meshes.

#include "geometry/mesh.h"
#include "math/index.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace glint::geometry {
namespace {

/// The bits of a position; adding +0 turns −0 into +0.
uvec3 position_key(const vec3& p) {
    return {std::bit_cast<std::uint32_t>(p.x + 0.0f), std::bit_cast<std::uint32_t>(p.y + 0.0f),
            std::bit_cast<std::uint32_t>(p.z + 0.0f)};
}

/// A 64-bit hash: multiply and fold, once for each word.
std::uint64_t hash_key(const uvec3& key) {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (const std::uint32_t word : {key.x, key.y, key.z}) {
        h = (h ^ word) * 0xff51afd7ed558ccdu;
        h ^= h >> 32;
    }
    return h;
}

/// An edge of its lower vertex; `up` if the triangle runs from the lower to the higher vertex.
struct HalfEdge {
    std::uint32_t high;
    bool up;
};

/// Calls visit(low, HalfEdge) for each edge of each triangle with welded corners, without edges of no length.
template <class Visit>
void for_each_half_edge(std::span<const uvec3> triangles, const std::vector<std::uint32_t>& first,
                        Visit visit) {
    for (const uvec3& triangle : triangles) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = first[triangle[k]];
            const std::uint32_t b = first[triangle[(k + 1) % 3]];
            if (a < b) visit(a, HalfEdge{b, true});
            if (b < a) visit(b, HalfEdge{a, false});
        }
    }
}

/// Whether the sum of `count` over the uses of each edge of one lower vertex is good. Sorts the edges.
template <class Count, class Good>
bool each_edge(std::span<HalfEdge> edges, Count count, Good good) {
    std::sort(edges.begin(), edges.end(),
              [](const HalfEdge& a, const HalfEdge& b) { return a.high < b.high; });
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        sum += count(edges[i]);
        const bool last = i + 1 == edges.size() || edges[i + 1].high != edges[i].high;
        if (last && !good(sum)) return false;
        if (last) sum = 0;
    }
    return true;
}

/// Whether each edge is used equally often in both directions.
bool balanced(std::span<HalfEdge> edges) {
    return each_edge(
        edges, [](const HalfEdge& e) { return e.up ? 1 : -1; },
        [](std::int64_t surplus) { return surplus == 0; });
}

/// Whether each edge is used an even number of times.
bool even(std::span<HalfEdge> edges) {
    return each_edge(
        edges, [](const HalfEdge&) { return 1; }, [](std::int64_t uses) { return uses % 2 == 0; });
}

dvec3 edge(const vec3& from, const vec3& to) { return dvec3(to) - dvec3(from); }

bool no_area_from(const vec3& a, const vec3& b, const vec3& c) {
    return glm::cross(edge(a, b), edge(a, c)) == dvec3(0.0);
}

/// Fast test in single precision: true if two products in the cross product differ by more than the rounding
/// of equal ones, so the triangle has an area; false if undecided.
bool surely_has_area(const vec3& a, const vec3& b, const vec3& c) {
    constexpr float rounding = 0x1p-20f;
    constexpr float min_difference = 0x1p-100f; // far above what underflows
    const vec3 e = b - a;
    const vec3 f = c - a;
    const auto differ = [](float p, float q) {
        const float difference = std::fabs(p - q);
        return difference > min_difference && difference > rounding * (std::fabs(p) + std::fabs(q));
    };
    return differ(e.x * f.y, e.y * f.x) || differ(e.y * f.z, e.z * f.y) || differ(e.z * f.x, e.x * f.z);
}

} // namespace

std::vector<std::uint32_t> weld_by_position(std::span<const vec3> positions) {
    // Open addressing, at most half full: searches take one or two steps.
    const std::size_t slots = std::bit_ceil(positions.size() * 2 + 1);
    std::vector<std::uint32_t> table(slots, invalid_index);
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const uvec3 key = position_key(positions[i]);
        std::size_t slot = hash_key(key) & (slots - 1);
        while (table[slot] != invalid_index && position_key(positions[table[slot]]) != key)
            slot = (slot + 1) & (slots - 1);
        if (table[slot] == invalid_index) table[slot] = static_cast<std::uint32_t>(i);
        first[i] = table[slot];
    }
    return first;
}

namespace {

/// Whether a test holds for the edges of each lower vertex of the welded mesh.
template <class Test>
bool all_edges(std::span<const vec3> positions, std::span<const uvec3> triangles, Test test) {
    const std::vector<std::uint32_t> first = weld_by_position(positions);

    // A counting sort by the lower vertex, so that few edges remain to compare at each.
    std::vector<std::size_t> begin(positions.size() + 1, 0);
    for_each_half_edge(triangles, first, [&](std::uint32_t low, HalfEdge) { ++begin[low + 1]; });
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<HalfEdge> edges(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for_each_half_edge(triangles, first, [&](std::uint32_t low, HalfEdge e) { edges[next[low]++] = e; });

    for (std::size_t i = 0; i + 1 < begin.size(); ++i)
        if (!test(std::span(edges).subspan(begin[i], begin[i + 1] - begin[i]))) return false;
    return true;
}

} // namespace

bool is_closed(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    return !triangles.empty() && all_edges(positions, triangles, balanced);
}

bool has_no_holes(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    return !triangles.empty() && all_edges(positions, triangles, even);
}

double signed_volume(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    if (triangles.empty()) return 0;
    // Tetrahedra to a vertex of the mesh: with a distant origin as apex their volumes would cancel.
    const vec3 apex = positions[triangles.front().x];
    double six_volumes = 0;
    for (const uvec3& t : triangles) {
        const dvec3 a = edge(apex, positions[t.x]);
        const dvec3 b = edge(apex, positions[t.y]);
        const dvec3 c = edge(apex, positions[t.z]);
        six_volumes += glm::dot(a, glm::cross(b, c));
    }
    return six_volumes / 6;
}

double sine_at_sharpest_edge(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    struct Wing {
        std::uint32_t low, high; ///< the edge
        std::uint32_t opposite;
        dvec3 across; ///< from the edge into the triangle, of unit length
    };
    const std::vector<std::uint32_t> first = weld_by_position(positions);
    std::vector<Wing> wings;
    for (const uvec3& t : triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = first[t[k]];
            const std::uint32_t b = first[t[(k + 1) % 3]];
            const std::uint32_t c = first[t[(k + 2) % 3]];
            const dvec3 along = edge(positions[a], positions[b]);
            const dvec3 up = edge(positions[a], positions[c]);
            const dvec3 across = up - along * (glm::dot(up, along) / glm::dot(along, along));
            const double length = glm::length(across);
            if (length > 0) wings.push_back({std::min(a, b), std::max(a, b), c, across / length});
        }
    std::sort(wings.begin(), wings.end(), [](const Wing& a, const Wing& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    double least = 1;
    for (auto one = wings.begin(); one != wings.end(); ++one)
        for (auto other = one + 1; other != wings.end(); ++other) {
            if (other->low != one->low || other->high != one->high) break;
            if (other->opposite == one->opposite || glm::dot(one->across, other->across) <= 0) continue;
            least = std::min(least, glm::length(glm::cross(one->across, other->across)));
        }
    return least;
}

bool is_degenerate(const vec3& a, const vec3& b, const vec3& c) {
    // Edges to two close corners may round to the same from a distant one, but not from these corners.
    if (surely_has_area(a, b, c)) return false;
    return no_area_from(a, b, c) && no_area_from(b, c, a) && no_area_from(c, a, b);
}

std::size_t drop_degenerate(std::span<const vec3> positions, std::vector<uvec3>& triangles) {
    const auto degenerate = [&](const uvec3& t) {
        return is_degenerate(positions[t.x], positions[t.y], positions[t.z]);
    };
    return std::erase_if(triangles, degenerate);
}

double angle_from(double sine, double cosine) {
    const double length = std::sqrt(sine * sine + cosine * cosine);
    if (!(length > 0)) return 0;

    // Tangent of half the angle to the nearer end of the axis, in [0, 1]; halved twice more it is below 0.2.
    double t = sine / (length + std::fabs(cosine));
    t = t / (1 + std::sqrt(1 + t * t));
    t = t / (1 + std::sqrt(1 + t * t));

    // Series of atan t; the first omitted term is below 1e-15.
    const double z = t * t;
    double series = 0;
    for (int k = 19; k >= 1; k -= 2) series = 1.0 / k - z * series;
    const double angle = 8 * t * series;
    return cosine < 0 ? 3.14159265358979323846 - angle : angle;
}

namespace {

/// Calls visit(k, normal) for each corner k of a triangle with an area: its unit normal times the angle
/// there.
template <class Visit>
void for_each_corner(std::span<const vec3> positions, const uvec3& t, Visit visit) {
    const dvec3 normal =
        glm::cross(edge(positions[t.x], positions[t.y]), edge(positions[t.x], positions[t.z]));
    const double area2 = glm::length(normal);
    if (!(area2 > 0)) return;

    // |cross| is the same at each corner; only the cosines differ.
    for (int k = 0; k < 3; ++k) {
        const vec3& corner = positions[t[k]];
        const dvec3 to_next = edge(corner, positions[t[(k + 1) % 3]]);
        const dvec3 to_last = edge(corner, positions[t[(k + 2) % 3]]);
        visit(k, normal / area2 * angle_from(area2, glm::dot(to_next, to_last)));
    }
}

vec3 unit_or_zero(const dvec3& sum) {
    const double length = glm::length(sum);
    return length > 0 ? vec3(sum / length) : vec3(0.0f);
}

/// Disjoint sets of numbers, each known by its least.
class Sets {
  public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax({find(a), find(b)});
        parent_[high] = low;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

/// An edge of a triangle between welded vertices, and the corners of the triangle there.
struct CornerEdge {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t at_low;
    std::uint32_t at_high;
};

std::vector<CornerEdge> sorted_edges(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    const std::vector<std::uint32_t> first = weld_by_position(positions);
    std::vector<CornerEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t next = (k + 1) % 3;
            const std::uint32_t a = first[triangles[i][int(k)]], b = first[triangles[i][int(next)]];
            edges.push_back(a < b ? CornerEdge{a, b, 3 * i + k, 3 * i + next}
                                  : CornerEdge{b, a, 3 * i + next, 3 * i + k});
        }
    std::sort(edges.begin(), edges.end(), [](const CornerEdge& a, const CornerEdge& b) {
        return std::tie(a.low, a.high, a.at_low) < std::tie(b.low, b.high, b.at_low);
    });
    return edges;
}

/// Corners at one vertex are in one set if edges that are no creases lead from one to the other.
Sets smooth_corners(std::span<const vec3> positions, std::span<const uvec3> triangles, double min_cosine) {
    const auto normal = [&](std::uint32_t corner) {
        const uvec3& t = triangles[corner / 3];
        const dvec3 n =
            glm::cross(edge(positions[t.x], positions[t.y]), edge(positions[t.x], positions[t.z]));
        const double length = glm::length(n);
        return length > 0 ? n / length : n;
    };
    Sets sets(3 * triangles.size());
    const std::vector<CornerEdge> edges = sorted_edges(positions, triangles);
    for (std::size_t i = 1; i < edges.size(); ++i) {
        const CornerEdge& a = edges[i - 1];
        const CornerEdge& b = edges[i];
        if (a.low != b.low || a.high != b.high) continue;
        if (glm::dot(normal(a.at_low), normal(b.at_low)) < min_cosine) continue;
        sets.unite(a.at_low, b.at_low);
        sets.unite(a.at_high, b.at_high);
    }
    return sets;
}

} // namespace

std::vector<vec3> smooth_normals(std::span<const vec3> positions, std::span<const uvec3> triangles) {
    const std::vector<std::uint32_t> first = weld_by_position(positions);
    std::vector<dvec3> sums(positions.size(), dvec3(0.0));
    for (const uvec3& t : triangles)
        for_each_corner(positions, t, [&](int k, const dvec3& normal) { sums[first[t[k]]] += normal; });

    std::vector<vec3> normals(positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = unit_or_zero(sums[first[i]]);
    return normals;
}

CreasedMesh split_at_creases(std::span<const vec3> positions, std::span<const uvec3> triangles,
                             double min_cosine) {
    Sets sets = smooth_corners(positions, triangles, min_cosine);
    std::vector<dvec3> sums(3 * triangles.size(), dvec3(0.0));
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for_each_corner(positions, triangles[i], [&](int k, const dvec3& normal) {
            sums[sets.find(3 * i + static_cast<std::uint32_t>(k))] += normal;
        });

    // Vertices at one position that differ otherwise, such as in colour, stay apart.
    CreasedMesh out;
    out.triangles.resize(triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> vertices;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t set = sets.find(3 * i + static_cast<std::uint32_t>(k));
            const auto next = static_cast<std::uint32_t>(out.source.size());
            const auto [vertex, is_new] = vertices.try_emplace({set, triangles[i][k]}, next);
            if (is_new) {
                out.source.push_back(triangles[i][k]);
                out.normals.push_back(unit_or_zero(sums[set]));
            }
            out.triangles[i][k] = vertex->second;
        }
    return out;
}

} // namespace glint::geometry
