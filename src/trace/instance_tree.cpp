// From instances to a tree of their boxes.

#include "trace/instance_tree.h"

#include "math/finite.h"
#include "math/inverse.h"

#include <map>
#include <stdexcept>

namespace glint {
namespace {

constexpr double unit = 0x1p-20; ///< 16 u
constexpr double most_squeezed = 0x1p20;

float below(double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float above(double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

/// How much |L| |L⁻¹| stretches errors; infinite or NaN where there is no inverse.
double stretch_of(const MeshInstance& instance, const dmat3& inverse) {
    return norm(instance.linear) * norm(inverse);
}

bool is_place(const MeshInstance& instance, double stretch) {
    const dmat3& m = instance.linear;
    return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]) && is_finite(instance.translation) &&
           stretch <= most_squeezed;
}

/// The boxes two levels below the root of a mesh's tree, 64 at most: turned one by one they fill a turned
/// mesh's box better than the mesh's own box would.
void add_boxes(const MeshTree& mesh, std::uint32_t node, int levels, std::vector<Bounds>& boxes) {
    const WideNode& at = mesh.nodes[node];
    for (int k = 0; k < wide_children && at.child[k] != no_child; ++k) {
        if (levels > 1 && (at.child[k] & leaf_bit) == 0)
            add_boxes(mesh, at.child[k], levels - 1, boxes);
        else
            boxes.push_back(
                {vec3(at.lo[0][k], at.lo[1][k], at.lo[2][k]), vec3(at.hi[0][k], at.hi[1][k], at.hi[2][k])});
    }
}

std::vector<Bounds> boxes_of(const MeshTree& mesh) {
    std::vector<Bounds> boxes;
    if (!mesh.nodes.empty()) add_boxes(mesh, 0, 2, boxes);
    if (boxes.empty()) boxes.push_back(mesh.bounds);
    return boxes;
}

/// Around a mesh's boxes in their place, grown by what no ray changes.
BoxRef box_of(const MeshInstance& instance, std::span<const Bounds> boxes, double stretch, std::uint32_t id) {
    const dmat3& m = instance.linear;
    const dmat3 size(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]));
    dvec3 least(std::numeric_limits<double>::infinity());
    dvec3 most = -least;
    for (const Bounds& box : boxes) {
        const dvec3 lo(box.lo);
        const dvec3 hi(box.hi);
        const dvec3 middle = m * ((lo + hi) * 0.5) + instance.translation;
        const dvec3 half = size * ((hi - lo) * 0.5);
        least = glm::min(least, middle - half);
        most = glm::max(most, middle + half);
    }
    const Bounds& whole = instance.mesh->bounds;
    const double reach = std::max(largest(dvec3(whole.lo)), largest(dvec3(whole.hi)));
    const dvec3 slack(unit * (norm(m) * reach + stretch * largest(instance.translation)));
    least -= slack;
    most += slack;
    return {vec3(below(least.x), below(least.y), below(least.z)), id,
            vec3(above(most.x), above(most.y), above(most.z))};
}

bool is_bounded(const BoxRef& box) { return is_finite(box.lo) && is_finite(box.hi); }

} // namespace

InstanceTree::InstanceTree(std::span<const MeshInstance> instances, TaskPool& pool) {
    if (instances.size() >= no_instance) throw std::length_error("too many instances");
    std::vector<BoxRef> boxes;
    std::vector<float> slack;
    places_.reserve(instances.size());
    boxes.reserve(instances.size());
    slack.reserve(instances.size());
    std::map<const MeshTree*, std::vector<Bounds>> parts;
    for (const MeshInstance& instance : instances) {
        const dmat3 inverse = inverted(instance.linear);
        const double stretch = stretch_of(instance, inverse);
        if (!is_place(instance, stretch))
            throw std::invalid_argument("the transform of an instance is singular or not finite");
        const auto id = static_cast<std::uint32_t>(places_.size());
        places_.push_back({instance.mesh, inverse, instance.translation});
        slack.push_back(above(unit * stretch));
        if (instance.mesh->bounds.empty()) continue;
        std::vector<Bounds>& mesh_boxes = parts[instance.mesh];
        if (mesh_boxes.empty()) mesh_boxes = boxes_of(*instance.mesh);
        boxes.push_back(box_of(instance, mesh_boxes, stretch, id));
        if (!is_bounded(boxes.back()))
            throw std::invalid_argument("an instance reaches beyond the range of floats");
    }
    tree_ = build_tree(std::move(boxes), 1, pool);
    slack_.resize(tree_.nodes.size());
    if (!tree_.empty()) most_slack_ = fill_slack(tree_.root, slack);
}

bool InstanceTree::takes(const MeshInstance& instance) {
    const double stretch = stretch_of(instance, inverted(instance.linear));
    return is_place(instance, stretch) &&
           (instance.mesh->bounds.empty() ||
            is_bounded(box_of(instance, {&instance.mesh->bounds, 1}, stretch, 0)));
}

float InstanceTree::fill_slack(TreeRef ref, const std::vector<float>& slack_of_instance) {
    if (ref.count > 0) return slack_of_instance[tree_.order[ref.first]];
    for (std::size_t child = 0; child < 2; ++child)
        slack_[ref.first][child] = fill_slack(tree_.nodes[ref.first].child[child], slack_of_instance);
    return std::max(slack_[ref.first][0], slack_[ref.first][1]);
}

std::size_t InstanceTree::bytes() const {
    return places_.size() * sizeof(Place) + tree_.nodes.size() * (sizeof(TreeNode) + sizeof slack_[0]) +
           tree_.order.size() * sizeof tree_.order[0];
}

} // namespace glint
