// Packet culling by interval arithmetic.

#include "trace/world/packet_bounds.h"

#include <cmath>
#include <limits>

namespace glint::trace {
namespace {

/// Error bound of double arithmetic with a large margin, relative to the largest product of a sum.
constexpr double plane_error = 0x1p-45;

/// Ignores NaN in p.
void grow(SimdBounds& box, float4 p) {
    box.lo = min4(p, box.lo);
    box.hi = max4(p, box.hi);
}

/// Largest |coordinate|; infinite if unknown.
double size_of(const SimdBounds& box) {
    double size = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const float x : {box.lo[axis], box.hi[axis]})
            size =
                std::isnan(x) ? std::numeric_limits<double>::infinity() : std::max(size, std::abs(double(x)));
    return size;
}

/// Range of normal · p for p in a box.
struct Dots {
    double lo = 0;
    double hi = 0;

    Dots(const dvec3& normal, const SimdBounds& box) {
        for (int axis = 0; axis < 3; ++axis) {
            const double a = normal[axis] * double(box.lo[axis]);
            const double b = normal[axis] * double(box.hi[axis]);
            lo += std::min(a, b);
            hi += std::max(a, b);
        }
    }
};

} // namespace

void RayBoxes::add(const Ray& ray) {
    if (!(ray.tmin < ray.tmax)) return;
    const float4 origin{ray.origin.x, ray.origin.y, ray.origin.z, ray.tmin};
    const float4 direction{ray.direction.x, ray.direction.y, ray.direction.z, ray.tmax};
    grow(starts, origin);
    grow(directions, direction);
    grow(ends, origin + direction * splat(ray.tmax));
}

PacketBounds::PacketBounds(const RayBoxes& boxes)
    : starts_(boxes.starts), directions_(boxes.directions), ends_(boxes.ends), start_size_(size_of(starts_)),
      direction_size_(size_of(directions_)) {
    const double end_size = size_of(ends_);
    end_pad_ = 0x1p-20 * (start_size_ + end_size) + 0x1p-140;
    empty_ = starts_.lo[3] > starts_.hi[3];
    forward_ = starts_.lo[3] >= 0.0f;
    bounded_ = end_size < std::numeric_limits<double>::infinity();
}

// If all origins are on one side of the plane by more than the error bound, and the padded ends too, the
// exact t is outside the interval by far more than its error; likewise if all rays lead away from the plane.
bool PacketBounds::misses(const PlanePrim& plane_prim) const {
    if (!forward_) return false;
    const dvec3& normal = plane_prim.plane.normal;
    const double offset = plane_prim.plane.offset;
    const double length = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    const double margin = plane_error * (length * start_size_ + std::abs(offset));
    const Dots starts(normal, starts_);
    const bool above = starts.lo - offset > margin;
    if (!above && !(offset - starts.hi > margin)) return false;
    const Dots slopes(normal, directions_);
    const double flat = plane_error * length * direction_size_;
    if (above ? slopes.lo > flat : -slopes.hi > flat) return true;
    if (!bounded_) return false;
    const Dots ends(normal, ends_);
    const double pad = length * end_pad_ + plane_error * std::abs(offset);
    return above ? ends.lo - offset > pad : offset - ends.hi > pad;
}

bool PacketBounds::misses(const Bounds& box, float slack) const {
    if (!forward_) return false;
    const double pad = 0x1p-20 * (start_size_ + double(box.max_coordinate())) + double(slack) * start_size_;
    if (bounded_)
        for (int axis = 0; axis < 3; ++axis) {
            const double lo = double(std::min(starts_.lo[axis], ends_.lo[axis])) - end_pad_;
            const double hi = double(std::max(starts_.hi[axis], ends_.hi[axis])) + end_pad_;
            if (lo > double(box.hi[axis]) + pad || hi < double(box.lo[axis]) - pad) return true;
        }
    return passes_by(box, pad);
}

/// Slab test by intervals: whether no t is valid for all three axes.
bool PacketBounds::passes_by(const Bounds& box, double pad) const {
    double enter = 0;
    double leave = double(directions_.hi[3]);
    for (int axis = 0; axis < 3; ++axis) {
        // Distances to the near and far side, bounded from below and above, in the direction of the rays.
        double slow = double(directions_.lo[axis]);
        double fast = double(directions_.hi[axis]);
        double near = double(box.lo[axis]) - pad - double(starts_.hi[axis]);
        double far = double(box.hi[axis]) + pad - double(starts_.lo[axis]);
        if (!(fast > 0.0)) {
            slow = -double(directions_.hi[axis]);
            fast = -double(directions_.lo[axis]);
            near = double(starts_.lo[axis]) - double(box.hi[axis]) - pad;
            far = double(starts_.hi[axis]) - double(box.lo[axis]) + pad;
        }
        if (!(slow >= 0.0)) continue;
        if (far < 0.0) return true;
        if (slow > 0.0) leave = std::min(leave, far / slow);
        if (near > 0.0) enter = std::max(enter, near / fast);
    }
    if (enter > leave) return true;
    // Rays with both signs: bound how far they spread by then.
    for (int axis = 0; axis < 3; ++axis) {
        const double up = double(directions_.hi[axis]) * leave;
        const double down = double(directions_.lo[axis]) * leave;
        if (!(up > 0.0 && down < 0.0)) continue;
        if (double(starts_.lo[axis]) + down > double(box.hi[axis]) + pad ||
            double(starts_.hi[axis]) + up < double(box.lo[axis]) - pad)
            return true;
    }
    return false;
}

CullMask cull(const WorldData& world, const TriangleBounds& bounds, const RayBoxes& boxes) {
    CullMask cull_mask;
    const PacketBounds packet(boxes);
    if (packet.empty()) return cull_mask;
    const auto bit = [](std::size_t i) { return std::uint64_t{1} << std::min<std::size_t>(i, 63); };
    for (std::size_t i = 0; i < world.planes.size(); ++i)
        if (!packet.misses(world.planes[i])) cull_mask.planes |= bit(i);
    if (world.quadrics.size() > few_quadrics)
        cull_mask.quadrics = packet.misses(world.quadric_tree.bounds) ? 0 : ~std::uint64_t{0};
    else
        for (std::size_t i = 0; i < world.quadrics.size(); ++i)
            if (!packet.misses(world.quadrics[i].box)) cull_mask.quadrics |= bit(i);
    cull_mask.triangles = !bounds.box.empty() && !packet.misses(bounds.box, bounds.slack);
    return cull_mask;
}

} // namespace glint::trace
