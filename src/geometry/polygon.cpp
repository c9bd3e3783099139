// Triangulation of polygons by fans and ear clipping.

#include "geometry/polygon.h"

#include <cmath>

namespace glint::geometry {
namespace {

/// Twice the signed area of a triangle, positive if counter-clockwise.
double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Projection along the dominant axis of the normal, mirrored such that the polygon runs counter-clockwise.
class PlaneProjection {
  public:
    /// `normal` of any length but zero.
    explicit PlaneProjection(const dvec3& normal) {
        const dvec3 size = glm::abs(normal);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        u_ = (axis + 1) % 3;
        v_ = (axis + 2) % 3;
        if (normal[axis] < 0) std::swap(u_, v_);
    }
    dvec2 operator()(const vec3& p) const { return {static_cast<double>(p[u_]), static_cast<double>(p[v_])}; }

  private:
    int u_;
    int v_;
};

/// Twice the vector area (Newell's normal), computed relative to the first corner.
dvec3 area_vector(std::span<const vec3> positions, std::span<const std::uint32_t> corners) {
    const dvec3 origin(positions[corners[0]]);
    dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(dvec3(positions[corners[i]]) - origin, dvec3(positions[corners[i + 1]]) - origin);
    return sum;
}

/// Whether every triangle of the fan from the first corner has an area and the polygon's orientation.
bool fan_covers(std::span<const vec3> positions, std::span<const std::uint32_t> corners,
                const PlaneProjection& projection) {
    const dvec2 hub = projection(positions[corners[0]]);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        if (!(turn(hub, projection(positions[corners[i]]), projection(positions[corners[i + 1]])) > 0))
            return false;
    return true;
}

void append_fan(std::span<const std::uint32_t> corners, std::vector<uvec3>& out) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        out.emplace_back(corners[0], corners[i], corners[i + 1]);
}

/// Cuts ears from a ring of corners until two remain. After each cut only its two neighbours are tested
/// again, against the corners that are not convex: quadratic at worst.
class EarClipper {
  public:
    explicit EarClipper(std::vector<dvec2> points) : points_(std::move(points)), ring_(points_.size()) {
        const std::size_t n = points_.size();
        for (std::size_t i = 0; i < n; ++i) ring_[i] = {(i + n - 1) % n, (i + 1) % n};
        for (std::size_t i = 0; i < n; ++i) measure(i);
        for (std::size_t i = 0; i < n; ++i) ring_[i].ear = is_ear(i);
    }

    /// Calls emit(a, b, c) with the numbers of the corners of each triangle.
    template <class Emit>
    void clip(Emit emit) {
        std::size_t at = 0;
        for (std::size_t left = points_.size(); left > 2; --left) {
            const std::size_t ear = choose(at, left);
            const std::size_t last = ring_[ear].last;
            const std::size_t next = ring_[ear].next;
            emit(last, ear, next);
            ring_[last].next = next;
            ring_[next].last = last;
            ring_[ear].cut = true;
            measure(last);
            measure(next);
            ring_[last].ear = is_ear(last);
            ring_[next].ear = is_ear(next);

            // Skipping the neighbour spreads the cuts around the ring, which gives fewer thin triangles.
            at = ring_[next].next;
        }
    }

  private:
    struct Corner {
        std::size_t last = 0;
        std::size_t next = 0;
        double turn = 0;     ///< positive: convex
        bool ear = false;    ///< its triangle lies inside the polygon
        bool cut = false;    ///< no longer in the ring
        bool listed = false; ///< in blockers_
    };

    void measure(std::size_t i) {
        Corner& c = ring_[i];
        c.turn = turn(points_[c.last], points_[i], points_[c.next]);
        if (c.turn > 0 || c.listed) return;
        blockers_.push_back(i);
        c.listed = true;
    }

    // If any corner of a simple polygon lies in an ear, one that is not convex does.
    bool is_ear(std::size_t i) const {
        const Corner& c = ring_[i];
        if (!(c.turn > 0)) return false;
        const dvec2& a = points_[c.last];
        const dvec2& b = points_[i];
        const dvec2& d = points_[c.next];
        for (const std::size_t k : blockers_) {
            if (ring_[k].cut || ring_[k].turn > 0) continue;
            const dvec2& p = points_[k];
            if (p == a || p == b || p == d) continue;
            if (turn(a, b, p) >= 0 && turn(b, d, p) >= 0 && turn(d, a, p) >= 0) return false;
        }
        return true;
    }

    /// The next ear from `at` on. A polygon that is not simple may have none: then a corner without area, or
    /// a convex one, or any, so that each round cuts one.
    std::size_t choose(std::size_t at, std::size_t left) const {
        std::size_t flat = points_.size();
        std::size_t convex = points_.size();
        for (std::size_t step = 0; step < left; ++step, at = ring_[at].next) {
            if (ring_[at].ear) return at;
            if (ring_[at].turn == 0) flat = at;
            if (ring_[at].turn > 0) convex = at;
        }
        if (flat < points_.size()) return flat;
        return convex < points_.size() ? convex : at;
    }

    std::vector<dvec2> points_;
    std::vector<Corner> ring_;
    std::vector<std::size_t> blockers_;
};

} // namespace

bool triangulate(std::span<const vec3> positions, std::span<const std::uint32_t> corners,
                 std::vector<uvec3>& out) {
    // Any triangulation will do for a polygon without area.
    const dvec3 normal = corners.size() > 3 ? area_vector(positions, corners) : dvec3(0.0);
    if (normal == dvec3(0.0)) {
        append_fan(corners, out);
        return true;
    }

    const PlaneProjection projection(normal);
    if (fan_covers(positions, corners, projection)) {
        append_fan(corners, out);
        return true;
    }

    if (corners.size() > max_concave_corners) return false;
    std::vector<dvec2> points;
    points.reserve(corners.size());
    for (const std::uint32_t corner : corners) points.push_back(projection(positions[corner]));
    EarClipper(std::move(points)).clip([&](std::size_t a, std::size_t b, std::size_t c) {
        out.emplace_back(corners[a], corners[b], corners[c]);
    });
    return true;
}

} // namespace glint::geometry
