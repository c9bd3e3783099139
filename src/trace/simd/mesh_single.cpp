// Single-ray kernels for every SIMD target: eight boxes, vertices or triangles at once. Box tests only have
// to be conservative and may use fused multiply-adds; the triangle test performs the operations of
// geometry/triangle.h.

#include "trace/mesh/scalar.h"
#include "trace/simd/kernel_table.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/simd/mesh_single.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include "trace/simd/mesh_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

TriangleRecord closest_single(const MeshTree& tree, const Ray& ray) { return closest_scalar(tree, ray); }
bool occluded_single(const MeshTree& tree, const Ray& ray) { return occluded_scalar(tree, ray); }

#else

namespace {

constexpr std::size_t stack_size = wide_children * (max_tree_depth + 1);

/// Constants of the slab test of one ray against the eight children of a node.
class SingleRay {
  public:
    SingleRay(const Ray& ray, const Bounds& bounds) {
        const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
        const vec3 reach = glm::abs(ray.origin);
        const vec3 d = glm::abs(ray.direction);
        const float longest = std::max(d.x, std::max(d.y, d.z));
        const float scale =
            std::max(reach.x, std::max(reach.y, reach.z)) + std::max(far.x, std::max(far.y, far.z));
        const float pad = 0x1p-20f * scale;
        const float min_size = std::max({longest * min_direction_ratio, scale * min_scale_ratio, 2.95e-39f});
        for (int axis = 0; axis < 3; ++axis) {
            const float clamped = std::max(d[axis], min_size);
            const float size = 1.0f / clamped;
            const float inverse = std::copysign(size, ray.direction[axis]);
            const float shift = ray.origin[axis] * inverse;
            inverse_[axis] = inverse;
            near_offset_[axis] = -(shift + pad * size);
            far_offset_[axis] = pad * size - shift;
            negative_[axis] = std::signbit(ray.direction[axis]);
        }
        tmin_ = ray.tmin;
    }

    /// The children whose boxes the ray meets in [tmin, limit] as bits, and its entry distances.
    std::uint32_t meets(const WideNode& node, float limit, float* entries) const {
        std::uint32_t met = 0;
        for (std::size_t i = 0; i < 8; i += lanes) {
            Floats near = hn::Set(df, tmin_);
            Floats far = hn::Set(df, limit);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float* first = negative_[axis] ? node.hi[axis] : node.lo[axis];
                const float* last = negative_[axis] ? node.lo[axis] : node.hi[axis];
                const Floats inverse = hn::Set(df, inverse_[axis]);
                near = hn::Max(near,
                               hn::MulAdd(hn::Load(df, first + i), inverse, hn::Set(df, near_offset_[axis])));
                far =
                    hn::Min(far, hn::MulAdd(hn::Load(df, last + i), inverse, hn::Set(df, far_offset_[axis])));
            }
            met |= bits_of(hn::Le(near, far)) << i;
            hn::Store(near, df, entries + i);
        }
        return met;
    }

  private:
    float inverse_[3];
    float near_offset_[3];
    float far_offset_[3];
    float tmin_;
    bool negative_[3];
};

struct StackEntry {
    std::uint32_t code;
    float t;
};

/// Pushes the children that the ray meets, farthest first, except the nearest one, which is returned.
StackEntry push_sorted(const WideNode& node, std::uint32_t met, const float* entries, StackEntry* stack,
                       std::size_t& size) {
    const auto first = static_cast<std::size_t>(std::countr_zero(met));
    StackEntry nearest{node.child[first], entries[first]};
    const std::size_t base = size;
    for (met &= met - 1; met != 0; met &= met - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(met));
        StackEntry entry{node.child[child], entries[child]};
        if (entry.t < nearest.t) std::swap(entry, nearest);
        std::size_t at = size++;
        for (; at > base && stack[at - 1].t < entry.t; --at) stack[at] = stack[at - 1];
        stack[at] = entry;
    }
    return nearest;
}

LeafRay leaf_ray_of(const Ray& ray, const geometry::ShearedRay& sheared) {
    const float limit = next_float(ray.tmax, -1.0f);
    return {sheared.ox, sheared.oy, sheared.oz, sheared.sx, sheared.sy,   sheared.sz,
            ray.tmin,   limit,      0.0f,       0.0f,       invalid_index};
}

/// Traces one ray; returns whether it hit. Visits the nearest child at once and pushes the others.
template <bool any>
bool follow(const MeshTree& tree, const Ray& ray, TriangleRecord& record) {
    const SingleRay box_ray(ray, tree.bounds);
    alignas(32) float entries[8];
    std::uint32_t met = box_ray.meets(tree.nodes[0], next_float(ray.tmax, -1.0f), entries);
    if (met == 0) return false;
    const geometry::ShearedRay sheared(ray);
    LeafRay leaf_ray = leaf_ray_of(ray, sheared);
    StackEntry stack[stack_size];
    std::size_t size = 0;
    StackEntry at = push_sorted(tree.nodes[0], met, entries, stack, size);
    for (;;) {
        if ((at.code & leaf_bit) != 0) {
            tally(&TraceCounters::leaves, 1);
            const Leaf leaf(tree, LeafCode{at.code});
            const LeafVectors vertices(leaf, sheared.kx, sheared.ky, sheared.kz);
            if (test_ray<any>(leaf, vertices, leaf.all(), leaf_ray) && any) return true;
        } else {
            tally(&TraceCounters::nodes, 1);
            const WideNode& node = tree.nodes[at.code];
            met = box_ray.meets(node, leaf_ray.limit, entries);
            if (met != 0) {
                at = push_sorted(node, met, entries, stack, size);
                continue;
            }
        }
        do {
            if (size == 0) {
                record = {leaf_ray.limit, leaf_ray.u, leaf_ray.v, leaf_ray.triangle};
                return leaf_ray.triangle != invalid_index;
            }
            at = stack[--size];
        } while (at.t > leaf_ray.limit);
    }
}

} // namespace

// Called by the batch kernels too.
TriangleRecord closest_single(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    const bool hit = !tree.nodes.empty() && is_traceable(ray) && follow<false>(tree, ray, record);
    return hit ? record : TriangleRecord{};
}
bool occluded_single(const MeshTree& tree, const Ray& ray) {
    TriangleRecord record;
    return !tree.nodes.empty() && is_traceable(ray) && follow<true>(tree, ray, record);
}

#endif

extern const SingleKernels single{closest_single, occluded_single};

} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint::trace {

const KernelTable<SingleKernels> single_kernels GLINT_KERNEL_TABLE(single);

} // namespace glint::trace
#endif
