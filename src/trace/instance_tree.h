#pragma once
// Meshes at many places: a tree over the boxes of instances, whose leaves take rays to the space of a mesh
// and ask the mesh's own kernels. Each mesh is stored once.
//
// A ray is taken to local space in double and rounded once; its direction keeps its length there, so that t
// means the same in both spaces. That one rounding, and the mesh's own test, may hit what is up to
//
//     12 u |L| (|L⁻¹| (|o| + |c|) + S')
//
// away in the world (u = 2^-24; L the linear part, c the translation; maximum norms; S' the largest
// |coordinate| of the mesh; bvh/traverse.h accounts for the rest). Boxes are grown by 16 u of what does not
// depend on the ray, and the box test by 16 u |L| |L⁻¹| |o|, kept for every node as the largest below it.

#include "bvh/traverse.h"
#include "bvh/tree.h"
#include "trace/mesh_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace glint {

inline constexpr std::uint32_t no_instance = 0xffffffffu;

/// The least (t, instance, triangle) of a ray, or instance = no_instance.
struct InstanceRecord {
    float t = std::numeric_limits<float>::infinity();
    float u = 0;
    float v = 0;
    std::uint32_t triangle = no_triangle;
    std::uint32_t instance = no_instance;
};

/// A mesh, and p_world = linear · p_local + translation.
struct MeshInstance {
    const MeshTree* mesh = nullptr;
    dmat3 linear{1.0};
    dvec3 translation{0.0};
};

class InstanceTree {
  public:
    InstanceTree() = default;
    /// Instances are numbered in the order given; the meshes must outlive the tree, which does not depend on
    /// the pool. Throws std::invalid_argument for a transform that is not finite, or singular: one that
    /// squeezes some direction more than a million times as much as another, or beyond the range of floats.
    InstanceTree(std::span<const MeshInstance> instances, TaskPool& pool);

    /// Does the constructor take it?
    static bool takes(const MeshInstance& instance);

    /// One ray.
    InstanceRecord closest(const Ray& ray, const KernelChoice& choice = {}) const;
    bool occluded(const Ray& ray, const KernelChoice& choice = {}) const;

    /// The least (t, instance, triangle) with tmin < t < tmax of each ray. rays and records have one length.
    void closest(std::span<const Ray> rays, std::span<InstanceRecord> records, RayHint hint,
                 const KernelChoice& choice = {}) const;
    /// Whether each ray hits anything with tmin < t < tmax: 1 or 0. rays and blocked have one length.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                  const KernelChoice& choice = {}) const;

    /// Calls visit(number) for every instance whose box meets the finite ray in [tmin, limit], roughly
    /// nearest first. `visit` may lower `limit` and ends the search by returning true.
    template <class Visit>
    void visit(const Ray& ray, const float& limit, Visit&& visit) const;

    /// The same ray in an instance's space: as the kernels see it, to the bit.
    Ray to_local(std::uint32_t instance, const Ray& ray) const {
        const Place& place = places_[instance];
        return {vec3(place.inverse * (dvec3(ray.origin) - place.translation)), ray.tmin,
                vec3(place.inverse * dvec3(ray.direction)), ray.tmax};
    }
    const MeshTree& mesh(std::uint32_t instance) const { return *places_[instance].mesh; }
    const dmat3& inverse(std::uint32_t instance) const { return places_[instance].inverse; }
    const dvec3& translation(std::uint32_t instance) const { return places_[instance].translation; }

    const Tree& tree() const { return tree_; } ///< over the boxes of the instances, one a leaf
    std::size_t size() const { return places_.size(); }
    const Bounds& bounds() const { return tree_.bounds; } ///< of the boxes: a little more than the triangles
    /// How far a ray must grow these bounds on every side, in its origin's largest |coordinate|, besides what
    /// every box test grows boxes by.
    float slack() const { return most_slack_; }
    int depth() const { return tree_.depth; }
    std::size_t nodes() const { return tree_.nodes.size(); }
    std::size_t bytes() const; ///< without the meshes

  private:
    struct Place {
        const MeshTree* mesh = nullptr;
        dmat3 inverse{1.0};
        dvec3 translation{0.0};
    };

    /// A ray against the boxes of this tree.
    struct Query {
        BoxRay box;
        float tmin;
        float reach; ///< the origin's largest |coordinate|

        Query(const Ray& ray, const Bounds& bounds)
            : box(ray, bounds), tmin(ray.tmin),
              reach(std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)})) {}
    };
    struct Batch;

    float fill_slack(TreeRef ref, const std::vector<float>& slack_of_instance);

    /// Where the ray enters a child's box within [tmin, limit]; infinite if it does not.
    float entry(const Query& query, std::uint32_t node, std::size_t child, float limit) const {
        const TreeNode& boxes = tree_.nodes[node];
        const float pad = query.box.pad + slack_[node][child] * query.reach;
        float first = query.tmin;
        float last = limit;
        for (int axis = 0; axis < 3; ++axis) {
            const float to_lo =
                (boxes.lo[axis][child] - query.box.origin[axis] - pad) * query.box.inverse[axis];
            const float to_hi =
                (boxes.hi[axis][child] - query.box.origin[axis] + pad) * query.box.inverse[axis];
            first = std::max(first, std::min(to_lo, to_hi));
            last = std::min(last, std::max(to_lo, to_hi));
        }
        return first <= last ? first : std::numeric_limits<float>::infinity();
    }

    /// visit() below a node, for a ray that may enter it.
    template <class Visit>
    void visit_below(TreeRef from, const Query& query, const float& limit, Visit&& visit) const;

    template <bool any>
    void trace(Batch& batch) const;
    template <bool any>
    void ask(std::uint32_t instance, Batch& batch) const;
    template <bool any>
    void ask_one_by_one(TreeRef from, Batch& batch) const;

    std::vector<Place> places_;
    Tree tree_;
    std::vector<std::array<float, 2>> slack_; ///< [node][child]: the box test's, in origins' |coordinates|
    float most_slack_ = 0;                    ///< of all
};

template <class Visit>
void InstanceTree::visit(const Ray& ray, const float& limit, Visit&& visit) const {
    if (!tree_.empty()) visit_below(tree_.root, Query(ray, tree_.bounds), limit, visit);
}

template <class Visit>
void InstanceTree::visit_below(TreeRef from, const Query& query, const float& limit, Visit&& visit) const {
    struct Waiting {
        TreeRef ref;
        float t;
    };
    Waiting stack[max_tree_depth + 1];
    std::size_t size = 0;
    stack[size++] = {from, query.tmin};
    while (size > 0) {
        const Waiting at = stack[--size];
        if (at.t > limit) continue;
        if (at.ref.count > 0) {
            if (visit(tree_.order[at.ref.first])) return;
            continue;
        }
        const float entries[2] = {entry(query, at.ref.first, 0, limit), entry(query, at.ref.first, 1, limit)};
        const std::size_t near = entries[1] < entries[0] ? 1 : 0;
        for (const std::size_t child : {1 - near, near})
            if (entries[child] <= limit)
                stack[size++] = {tree_.nodes[at.ref.first].child[child], entries[child]};
    }
}

} // namespace glint
