#pragma once
// A two-level BVH: a tree over the boxes of instances, whose leaves transform rays to the local space of a
// mesh and trace the mesh's own tree. Each mesh is stored once.
//
// A ray is transformed in double precision and rounded once; its direction is not normalized, so t is the
// same in both spaces. That rounding, together with the mesh's own test, may hit geometry up to
//
//     12 u |L| (|L⁻¹| (|o| + |c|) + S')
//
// away in world space (u = 2^-24; L the linear part, c the translation; maximum norms; S' the largest
// |coordinate| of the mesh; bvh/traverse.h accounts for the rest). Boxes are grown by 16 u of the terms that
// do not depend on the ray, and the box test by 16 u |L| |L⁻¹| |o|, stored for every node as the maximum of
// its subtree.

#include "bvh/traverse.h"
#include "bvh/tree.h"
#include "trace/mesh/tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glint::trace {

/// The least (t, instance, triangle) of a ray, or instance = invalid_index.
using InstanceRecord = tracing::InstanceHit;

/// An instance of a mesh: p_world = linear · p_local + translation.
struct MeshInstance {
    const MeshTree* mesh = nullptr;
    dmat3 linear{1.0};
    dvec3 translation{0.0};
};

class InstanceTree {
  public:
    InstanceTree() = default;
    /// Instances are numbered in the order given. Meshes must outlive the tree. The tree does not depend on
    /// the number of threads. Throws std::invalid_argument for a transform that is not finite, nearly
    /// singular (condition number above 2^20, about a million), or that exceeds the range of floats.
    InstanceTree(std::span<const MeshInstance> instances, parallel::TaskPool& pool);

    /// Whether the constructor accepts the instance, and it is not so small that rays of ordinary size leave
    /// the range of floats in its space.
    static bool accepts(const MeshInstance& instance);

    /// Single-ray queries.
    InstanceRecord closest(const Ray& ray, const KernelChoice& choice = {}) const;
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;

    /// The least (t, instance, triangle) with tmin < t < tmax of each ray. `rays` and `records` have equal
    /// length.
    void closest(std::span<const Ray> rays, std::span<InstanceRecord> records, RayHint hint,
                 const KernelChoice& choice = {}) const;
    /// Whether each ray hits anything with tmin < t < tmax: 1 or 0. `rays` and `blocked` have equal length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                  const KernelChoice& choice = {}) const;

    /// Calls visit(index) for every instance whose box meets the finite ray in [tmin, limit], roughly nearest
    /// first. `visit` may lower `limit`; it ends the search by returning true.
    template <class Visit>
    void visit(const Ray& ray, const float& limit, Visit&& visit) const;

    /// The ray in local space of an instance, bit for bit as the kernels see it.
    Ray to_local(std::uint32_t instance, const Ray& ray) const {
        const Instance& at = instances_[instance];
        return {vec3(at.inverse * (dvec3(ray.origin) - at.translation)), ray.tmin,
                vec3(at.inverse * dvec3(ray.direction)), ray.tmax};
    }
    const MeshTree& mesh(std::uint32_t instance) const { return *instances_[instance].mesh; }
    const dmat3& inverse(std::uint32_t instance) const { return instances_[instance].inverse; }
    const dvec3& translation(std::uint32_t instance) const { return instances_[instance].translation; }

    const Tree& tree() const { return tree_; } ///< over the boxes of the instances, one instance a leaf
    std::size_t size() const { return instances_.size(); }
    const Bounds& bounds() const {
        return tree_.bounds;
    } ///< of the boxes, slightly larger than those of the triangles
    /// Factor of the origin's largest |coordinate| by which a ray must grow these bounds on every side, in
    /// addition to the pad of every box test.
    float slack() const { return max_slack_; }
    int depth() const { return tree_.depth; }
    std::size_t nodes() const { return tree_.nodes.size(); }
    std::size_t bytes() const; ///< without the meshes

  private:
    struct Instance {
        const MeshTree* mesh = nullptr;
        dmat3 inverse{1.0};
        dvec3 translation{0.0};
    };

    /// A ray with constants for the box tests of this tree.
    struct Query {
        BoxRay box;
        float tmin;
        float reach; ///< largest |coordinate| of the origin

        Query(const Ray& ray, const Bounds& bounds)
            : box(ray, bounds), tmin(ray.tmin),
              reach(std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)})) {}
    };
    struct Batch;

    float fill_slack(TreeRef ref, const std::vector<float>& slack_of_instance);

    /// Where the ray enters a child's box within [tmin, limit]; infinite if it misses.
    float entry(const Query& query, std::uint32_t node, std::size_t child, float limit) const {
        const float pad = query.box.pad + slack_[node][child] * query.reach;
        return entry_distance(tree_.nodes[node], child, query.box, pad, query.tmin, limit);
    }

    /// visit() of a subtree, for a ray that may enter it.
    template <class Visit>
    void visit_below(TreeRef from, const Query& query, const float& limit, Visit&& visit) const;

    template <class Result>
    void trace_batches(std::span<const Ray> rays, std::span<Result> results, RayHint hint,
                       const KernelChoice& choice) const;
    template <bool any>
    void trace(Batch& batch) const;
    template <bool any>
    void trace_instance(std::uint32_t instance, Batch& batch) const;
    template <bool any>
    void trace_each(TreeRef from, Batch& batch) const;

    std::vector<Instance> instances_;
    Tree tree_;
    std::vector<std::array<float, 2>>
        slack_;           ///< [node][child]: growth of the box test per unit of the origin's |coordinate|
    float max_slack_ = 0; ///< maximum of slack_
};

template <class Visit>
void InstanceTree::visit(const Ray& ray, const float& limit, Visit&& visit) const {
    if (!tree_.empty()) visit_below(tree_.root, Query(ray, tree_.bounds), limit, visit);
}

template <class Visit>
void InstanceTree::visit_below(TreeRef from, const Query& query, const float& limit, Visit&& visit) const {
    const auto enter = [&](std::uint32_t node, float(&entries)[2]) {
        for (std::size_t child = 0; child < 2; ++child) entries[child] = entry(query, node, child, limit);
    };
    traverse_below(tree_, from, limit, enter,
                   [&](std::uint32_t first, std::uint32_t) { return visit(tree_.order[first]); });
}

} // namespace glint::trace
