// Binned search for spatial splits, clipping of triangles, and partitioning with duplication of references.

#include "trace/mesh/split.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace glint::trace {
namespace {

constexpr int slices = 16;

/// Bound on the rounding error of an interpolated point: at most 11 · 2^-24 of the larger coordinate on each
/// axis, plus the smallest normal float for underflow.
float4 clipping_error(float4 a, float4 b) {
    return (max4(a, -a) + max4(b, -b)) * splat(0x1p-20f) + splat(std::numeric_limits<float>::min());
}

bool is_empty(const SimdBounds& box) {
    return box.lo[0] > box.hi[0] || box.lo[1] > box.hi[1] || box.lo[2] > box.hi[2];
}

struct SpatialBins {
    std::array<SimdBounds, slices> boxes;
    std::array<std::uint32_t, slices> begins{}; ///< number of references whose first part is in this bin
    std::array<std::uint32_t, slices> ends{};   ///< likewise their last part
};

/// Equidistant planes through a range's box.
struct Planes {
    float lo;
    float step;
    float scale; ///< 0 if the extent is too small to separate planes

    Planes(const SimdBounds& box, int axis) : lo(box.lo[axis]), step(0), scale(0) {
        const float extent = box.hi[axis] - lo;
        const float factor = static_cast<float>(slices) / extent;
        if (!(extent > 0.0f) || !(factor < 1e30f)) return;
        step = extent / static_cast<float>(slices);
        scale = factor;
    }
    int bin(float x) const { return std::clamp(static_cast<int>((x - lo) * scale), 0, slices - 1); }
    /// The plane between bin − 1 and bin.
    float plane(int bin) const { return lo + step * static_cast<float>(bin); }
};

void add(const MeshBuild& build, PrimRef ref, int axis, const Planes& planes, SpatialBins& out) {
    const auto first = static_cast<std::size_t>(planes.bin(ref.lo[axis]));
    const auto last = static_cast<std::size_t>(planes.bin(ref.hi[axis]));
    ++out.begins[first];
    ++out.ends[last];
    for (std::size_t bin = first; bin < last; ++bin) {
        const ClippedBoxes parts = clip(build, ref, axis, planes.plane(static_cast<int>(bin) + 1));
        if (!is_empty(parts.left)) out.boxes[bin].grow(parts.left);
        if (is_empty(parts.right)) return;
        ref = PrimRef::of(parts.right.lo, parts.right.hi, ref.id());
    }
    out.boxes[last].grow(ref.box());
}

void sweep(const SpatialBins& filled, const Planes& planes, const PrimRange& range, float scale, int axis,
           SpatialCut& best) {
    std::array<float, slices> right_area;
    SimdBounds box;
    for (std::size_t i = slices - 1; i > 0; --i) {
        box.grow(filled.boxes[i]);
        right_area[i] = half_area(box, scale);
    }
    box = {};
    std::size_t left = 0;
    std::size_t right = range.size();
    for (std::size_t i = 1; i < slices; ++i) {
        box.grow(filled.boxes[i - 1]);
        left += filled.begins[i - 1];
        right -= filled.ends[i - 1];
        if (left == 0 || right == 0 || left + right > range.capacity()) continue;
        const float cost =
            half_area(box, scale) * static_cast<float>(left) + right_area[i] * static_cast<float>(right);
        if (cost < best.cost) best = {axis, planes.plane(static_cast<int>(i)), cost};
    }
}

/// Partitions references at a plane: left ones to the front, right ones to the back, duplicates behind the
/// end.
class SpatialPartition {
  public:
    SpatialPartition(const MeshBuild& build, const PrimRange& range, const SpatialCut& cut)
        : build_(build), range_(range), cut_(cut), end_(range.end) {
        left_.depth = right_.depth = range.depth + 1;
    }

    bool run(std::pair<PrimRange, PrimRange>& sides) {
        PrimRef* refs = build_.refs;
        std::size_t i = range_.begin;
        std::size_t j = range_.end;
        while (i < j) {
            if (is_left(refs[i])) {
                left_.add(refs[i++]);
            } else {
                std::swap(refs[i], refs[--j]);
                right_.add(refs[j]);
            }
        }
        left_.begin = range_.begin;
        left_.end = right_.begin = i;
        right_.end = end_;
        assert(end_ <= range_.limit);
        if (left_.size() == 0 || right_.size() == 0) return false;
        share_capacity(left_, right_, range_.limit, refs);
        sides = {left_, right_};
        return true;
    }

  private:
    /// Decides the side of a reference. One on both sides is clipped, and its right part appended.
    bool is_left(PrimRef& ref) {
        if (ref.hi[cut_.axis] <= cut_.plane) return true;
        if (ref.lo[cut_.axis] >= cut_.plane) return false;
        const ClippedBoxes parts = clip(build_, ref, cut_.axis, cut_.plane);
        if (is_empty(parts.left)) return false;
        if (is_empty(parts.right)) return true;
        if (end_ == range_.limit) return ref.lo[cut_.axis] + ref.hi[cut_.axis] < 2.0f * cut_.plane;
        build_.refs[end_] = PrimRef::of(parts.right.lo, parts.right.hi, ref.id());
        right_.add(build_.refs[end_++]);
        ref = PrimRef::of(parts.left.lo, parts.left.hi, ref.id());
        return true;
    }

    const MeshBuild& build_;
    const PrimRange& range_;
    const SpatialCut& cut_;
    std::size_t end_;
    PrimRange left_;
    PrimRange right_;
};

} // namespace

ClippedBoxes clip(const MeshBuild& build, const PrimRef& ref, int axis, float plane) {
    const uvec3 corners = build.triangles[ref.id()];
    const std::array<float4, 3> v{to_float4(build.positions[corners.x]),
                                  to_float4(build.positions[corners.y]),
                                  to_float4(build.positions[corners.z])};
    ClippedBoxes parts;
    for (std::size_t i = 0; i < 3; ++i) {
        const float4 a = v[i];
        const float4 b = v[i == 2 ? 0 : i + 1];
        if (a[axis] <= plane) parts.left.grow(a);
        if (a[axis] >= plane) parts.right.grow(a);
        if (!((a[axis] < plane && plane < b[axis]) || (b[axis] < plane && plane < a[axis]))) continue;
        const float t = (plane - a[axis]) / (b[axis] - a[axis]);
        const float4 p = a + (b - a) * splat(t);
        const float4 error = clipping_error(a, b);
        const SimdBounds around{p - error, p + error};
        parts.left.grow(around);
        parts.right.grow(around);
    }
    parts.left.hi[axis] = std::min(parts.left.hi[axis], plane);
    parts.right.lo[axis] = std::max(parts.right.lo[axis], plane);
    parts.left.intersect(ref.box());
    parts.right.intersect(ref.box());
    return parts;
}

SpatialCut cheapest_spatial_cut(const MeshBuild& build, const PrimRange& range) {
    float4 lengths{};
    for (std::size_t i = range.begin; i < range.end; ++i)
        lengths += build.refs[i].hi - without_w(build.refs[i].lo);
    SpatialCut best;
    // Give up if clipping might overflow.
    if (!std::isfinite(lengths[0] + lengths[1] + lengths[2])) return best;
    for (int axis = 0; axis < 3; ++axis) {
        const Planes planes(range.box, axis);
        // The expected number of references cut by a random plane.
        const float cuts = lengths[axis] / (range.box.hi[axis] - range.box.lo[axis]);
        if (planes.scale == 0.0f || !(cuts <= static_cast<float>(range.limit - range.end))) continue;
        SpatialBins filled;
        for (std::size_t i = range.begin; i < range.end; ++i) add(build, build.refs[i], axis, planes, filled);
        sweep(filled, planes, range, build.scale, axis, best);
    }
    return best;
}

bool split_at(const MeshBuild& build, const PrimRange& range, const SpatialCut& cut,
              std::pair<PrimRange, PrimRange>& sides) {
    return SpatialPartition(build, range, cut).run(sides);
}

} // namespace glint::trace
