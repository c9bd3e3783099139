// Building an InstanceTree.

#include "trace/world/instance_tree.h"

#include <map>
#include <stdexcept>

namespace glint::trace {
namespace {

constexpr double grown_by = 0x1p-20; ///< 16 u
constexpr double max_condition = 0x1p20;
/// Rays with coordinates up to 10^12 stay within the range of floats in the space of a mesh.
constexpr double max_inverse = 0x1p80;

float below(double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float above(double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

/// The condition number |L| |L⁻¹|, which amplifies errors; infinite or NaN if L is singular.
double condition_of(const MeshInstance& instance, const dmat3& inverse) {
    return norm(instance.linear) * norm(inverse);
}

bool is_valid(const MeshInstance& instance, double condition) {
    const dmat3& m = instance.linear;
    return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]) && is_finite(instance.translation) &&
           condition <= max_condition;
}

/// The boxes two levels below the root of a mesh's tree, at most 64: transformed one by one they bound a
/// rotated mesh more tightly than its bounding box.
void add_boxes(const MeshTree& mesh, std::uint32_t node, int levels, std::vector<Bounds>& boxes) {
    const WideNode& at = mesh.nodes[node];
    for (std::size_t k = 0; k < wide_children && at.child[k] != invalid_index; ++k) {
        if (levels > 1 && (at.child[k] & leaf_bit) == 0)
            add_boxes(mesh, at.child[k], levels - 1, boxes);
        else
            boxes.push_back(child_box(at, k));
    }
}

std::vector<Bounds> boxes_of(const MeshTree& mesh) {
    std::vector<Bounds> boxes;
    if (!mesh.nodes.empty()) add_boxes(mesh, 0, 2, boxes);
    if (boxes.empty()) boxes.push_back(mesh.bounds);
    return boxes;
}

/// World-space bounds of the boxes of a mesh, grown by the error terms that do not depend on the ray.
BoxRef box_of(const MeshInstance& instance, std::span<const Bounds> boxes, double condition,
              std::uint32_t id) {
    const dmat3& m = instance.linear;
    const dmat3 size(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]));
    dvec3 lo(std::numeric_limits<double>::infinity());
    dvec3 hi = -lo;
    for (const Bounds& box : boxes) {
        const dvec3 box_lo(box.lo);
        const dvec3 box_hi(box.hi);
        const dvec3 middle = m * ((box_lo + box_hi) * 0.5) + instance.translation;
        const dvec3 half = size * ((box_hi - box_lo) * 0.5);
        lo = glm::min(lo, middle - half);
        hi = glm::max(hi, middle + half);
    }
    const double reach = double(instance.mesh->bounds.max_coordinate());
    const dvec3 slack(grown_by * (norm(m) * reach + condition * largest(instance.translation)));
    lo -= slack;
    hi += slack;
    return {vec3(below(lo.x), below(lo.y), below(lo.z)), id, vec3(above(hi.x), above(hi.y), above(hi.z))};
}

bool is_bounded(const BoxRef& box) { return is_finite(box.lo) && is_finite(box.hi); }

} // namespace

InstanceTree::InstanceTree(std::span<const MeshInstance> instances, parallel::TaskPool& pool) {
    if (instances.size() >= invalid_index) throw std::length_error("too many instances");
    std::vector<BoxRef> boxes;
    std::vector<float> slack;
    instances_.reserve(instances.size());
    boxes.reserve(instances.size());
    slack.reserve(instances.size());
    std::map<const MeshTree*, std::vector<Bounds>> parts;
    for (const MeshInstance& instance : instances) {
        const dmat3 inverse = inverted(instance.linear);
        const double condition = condition_of(instance, inverse);
        if (!is_valid(instance, condition))
            throw std::invalid_argument("the transform of an instance is singular or not finite");
        const auto id = static_cast<std::uint32_t>(instances_.size());
        instances_.push_back({instance.mesh, inverse, instance.translation});
        slack.push_back(above(grown_by * condition));
        if (instance.mesh->bounds.empty()) continue;
        std::vector<Bounds>& mesh_boxes = parts[instance.mesh];
        if (mesh_boxes.empty()) mesh_boxes = boxes_of(*instance.mesh);
        boxes.push_back(box_of(instance, mesh_boxes, condition, id));
        if (!is_bounded(boxes.back()))
            throw std::invalid_argument("an instance reaches beyond the range of floats");
    }
    tree_ = build_tree(std::move(boxes), 1, pool);
    slack_.resize(tree_.nodes.size());
    if (!tree_.empty()) max_slack_ = fill_slack(tree_.root, slack);
}

bool InstanceTree::accepts(const MeshInstance& instance) {
    const dmat3 inverse = inverted(instance.linear);
    const double condition = condition_of(instance, inverse);
    return is_valid(instance, condition) && norm(inverse) <= max_inverse &&
           (instance.mesh->bounds.empty() ||
            is_bounded(box_of(instance, {&instance.mesh->bounds, 1}, condition, 0)));
}

float InstanceTree::fill_slack(TreeRef ref, const std::vector<float>& slack_of_instance) {
    if (ref.count > 0) return slack_of_instance[tree_.order[ref.first]];
    for (std::size_t child = 0; child < 2; ++child)
        slack_[ref.first][child] = fill_slack(tree_.nodes[ref.first].child[child], slack_of_instance);
    return std::max(slack_[ref.first][0], slack_[ref.first][1]);
}

std::size_t InstanceTree::bytes() const {
    return instances_.size() * sizeof(Instance) + tree_.nodes.size() * (sizeof(TreeNode) + sizeof slack_[0]) +
           tree_.order.size() * sizeof tree_.order[0];
}

} // namespace glint::trace
