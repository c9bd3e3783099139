#include "gpu/tree.h"

#include "glint/error.h"
#include "trace/world/data.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::gpu {

using bvh::Tree;
using bvh::TreeNode;
using bvh::TreeRef;
using trace::leaf_bit;
using trace::MeshTree;
using trace::SharedMesh;
using trace::wide_children;
using trace::WideNode;
using trace::WorldData;
namespace {

constexpr std::uint32_t max_nodes = 0x00ffffffu;
constexpr std::uint32_t max_leaf_units = 0x02000000u;

/// A child of a node.
struct Child {
    Bounds box;
    std::uint32_t code = 0;
};

/// The unit along a node's axis: the least power of two that spans the axis in 255 steps.
int exponent_for(double extent) {
    int exponent = 0;
    std::frexp(extent / 255.0, &exponent);
    return std::clamp(exponent, -126, 127);
}

/// The child in each slot: the one that lies furthest toward a corner gets that corner's number.
std::array<int, wide_children> slots_of(const std::vector<Child>& children, const Bounds& all) {
    std::array<int, wide_children> child_at;
    child_at.fill(-1);
    std::vector<bool> placed(children.size(), false);
    for (std::size_t round = 0; round < children.size(); ++round) {
        float most = -std::numeric_limits<float>::infinity();
        std::size_t best_child = 0;
        std::size_t best_slot = 0;
        for (std::size_t c = 0; c < children.size(); ++c) {
            if (placed[c]) continue;
            const vec3 away = (children[c].box.lo - all.lo) + (children[c].box.hi - all.hi);
            for (std::size_t slot = 0; slot < wide_children; ++slot) {
                const vec3 corner((slot & 1) != 0 ? 1.0f : -1.0f, (slot & 2) != 0 ? 1.0f : -1.0f,
                                  (slot & 4) != 0 ? 1.0f : -1.0f);
                const float reach = glm::dot(away, corner);
                if (child_at[slot] >= 0 || !(reach > most)) continue;
                most = reach;
                best_child = c;
                best_slot = slot;
            }
        }
        // Boxes beyond the range of floats have no order: any slot will do.
        if (!(most > -std::numeric_limits<float>::infinity())) {
            best_child = std::size_t(std::find(placed.begin(), placed.end(), false) - placed.begin());
            best_slot = std::size_t(std::find(child_at.begin(), child_at.end(), -1) - child_at.begin());
        }
        placed[best_child] = true;
        child_at[best_slot] = static_cast<int>(best_child);
    }
    return child_at;
}

/// A node over its children, at most eight; grows `max_coordinate` to that of its boxes.
NodeRecord make_node(const std::vector<Child>& children, float& max_coordinate) {
    Bounds all;
    for (const Child& child : children) all.grow(child.box);
    const std::array<int, wide_children> child_at = slots_of(children, all);
    NodeRecord node{};
    node.origin = all.lo;
    uvec4* const sides[] = {&node.sides_x, &node.sides_y, &node.sides_z};
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = all.lo[axis];
        const int exponent = exponent_for(double(all.hi[axis]) - origin);
        const double step = std::ldexp(1.0, exponent);
        node.exponents_and_mask |= static_cast<std::uint32_t>(exponent + 127) << (8 * axis);
        for (std::size_t slot = 0; slot < wide_children; ++slot) {
            if (child_at[slot] < 0) continue;
            const Bounds& box = children[std::size_t(child_at[slot])].box;
            const double low = std::clamp(std::floor((double(box.lo[axis]) - origin) / step), 0.0, 255.0);
            const double high = std::clamp(std::ceil((double(box.hi[axis]) - origin) / step), 0.0, 255.0);
            const auto shift = static_cast<std::uint32_t>(8 * (slot % 4));
            const auto half = static_cast<int>(slot / 4);
            (*sides[axis])[half] |= static_cast<std::uint32_t>(low) << shift;
            (*sides[axis])[2 + half] |= static_cast<std::uint32_t>(high) << shift;
            max_coordinate = std::max({max_coordinate, static_cast<float>(std::abs(origin)),
                                       static_cast<float>(std::abs(origin + high * step))});
        }
    }
    for (std::size_t slot = 0; slot < wide_children; ++slot) {
        if (child_at[slot] < 0) continue;
        node.exponents_and_mask |= 1u << (24 + slot);
        node.children[slot] = children[std::size_t(child_at[slot])].code;
    }
    return node;
}

int depth_below(const MeshTree& tree, std::uint32_t node) {
    int deepest = 0;
    for (const std::uint32_t code : tree.nodes[node].child)
        if (code != invalid_index && (code & leaf_bit) == 0)
            deepest = std::max(deepest, depth_below(tree, code));
    return deepest + 1;
}

class Builder {
  public:
    explicit Builder(const WorldData& world) : world_(world) {}

    GpuTree run() {
        const std::uint32_t mesh_root = add_mesh(world_.mesh_tree, tree_.max_coordinate);
        int mesh_depth = depth_;
        for (const SharedMesh& mesh : world_.shared_meshes) {
            depth_ = 0;
            float max_coordinate = 0;
            tree_.mesh_roots.push_back(add_mesh(mesh.tree, max_coordinate));
            tree_.mesh_max_coordinates.push_back(max_coordinate);
            mesh_depth = std::max(mesh_depth, depth_ + 1);
        }
        depth_ = 0;
        const std::uint32_t wide_root = add_wide();
        mesh_depth = std::max(mesh_depth, depth_);
        depth_ = 0;
        std::vector<Item> items;
        if (mesh_root != invalid_index) items.push_back({world_.mesh_tree.bounds, nullptr, {}, mesh_root});
        if (wide_root != invalid_index) items.push_back({world_.wide_tree.bounds, nullptr, {}, wide_root});
        const Tree& instances = world_.instance_tree.tree();
        if (!instances.empty()) items.push_back({instances.bounds, &instances, instances.root, 0});
        const Tree& quadrics = world_.quadric_tree;
        if (!quadrics.empty()) items.push_back({quadrics.bounds, &quadrics, quadrics.root, 0});
        if (!items.empty()) tree_.root = add_top(std::move(items), 1);
        // A traversal leaves one entry in each node, and one more where it enters an instance.
        tree_.stack = depth_ + mesh_depth + 2;
        return std::move(tree_);
    }

  private:
    /// A child of an upper node: a subtree of a binary tree, or a code.
    struct Item {
        Bounds box;
        const Tree* tree = nullptr;
        TreeRef ref;
        std::uint32_t code = 0;

        bool can_open() const { return tree != nullptr && ref.count == 0; }
    };

    std::uint32_t new_nodes(std::size_t count) {
        const std::size_t first = tree_.nodes.size();
        if (first + count > max_nodes)
            throw Error(ErrorKind::device,
                        "the scene's tree has more than " + std::to_string(max_nodes) +
                            " nodes, which is what the GPU's can have",
                        "render on the CPU");
        tree_.nodes.resize(first + count);
        return static_cast<std::uint32_t>(first);
    }

    std::uint32_t add_mesh(const MeshTree& mesh, float& max_coordinate) {
        if (mesh.nodes.empty()) return invalid_index;
        const std::uint32_t first = new_nodes(mesh.nodes.size());
        const std::size_t units = tree_.leaves.size() / 4;
        tree_.leaves.insert(tree_.leaves.end(), mesh.leaf_words.begin(), mesh.leaf_words.end());
        tree_.leaves.resize((tree_.leaves.size() + 3) / 4 * 4);
        if (tree_.leaves.size() / 4 > max_leaf_units)
            throw Error(ErrorKind::device,
                        "the scene's triangles take more than the 512 MiB that the GPU's tree can name",
                        "render on the CPU, or show meshes more than once as instances");
        std::vector<Child> children;
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            const WideNode& node = mesh.nodes[i];
            children.clear();
            for (std::size_t c = 0; c < wide_children; ++c) {
                const std::uint32_t code = node.child[c];
                if (code == invalid_index) continue;
                Child child;
                child.box = {{node.lo[0][c], node.lo[1][c], node.lo[2][c]},
                             {node.hi[0][c], node.hi[1][c], node.hi[2][c]}};
                child.code = (code & leaf_bit) != 0 ? code + static_cast<std::uint32_t>(units) : code + first;
                children.push_back(child);
            }
            tree_.nodes[first + i] = make_node(children, max_coordinate);
        }
        depth_ = std::max(depth_, depth_below(mesh, 0));
        return first;
    }

    /// Its triangles are numbered after those of mesh_tree.
    std::uint32_t add_wide() {
        const MeshTree& wide = world_.wide_tree;
        if (wide.nodes.empty()) return invalid_index;
        const std::size_t first_word = tree_.leaves.size();
        tree_.first_wide_leaf = static_cast<std::uint32_t>(first_word / 4);
        const std::uint32_t root = add_mesh(wide, tree_.max_coordinate);
        const auto first_number = static_cast<std::uint32_t>(world_.mesh_tree.triangles);
        for (const WideNode& node : wide.nodes)
            for (const std::uint32_t code : node.child) {
                if (code == invalid_index || (code & leaf_bit) == 0) continue;
                const trace::LeafCode leaf{code};
                const std::size_t numbers = first_word + leaf.word() + 4 + 3 * leaf.vertices();
                for (std::uint32_t i = 0; i < leaf.triangles(); ++i)
                    tree_.leaves[numbers + i] += first_number;
            }
        return root;
    }

    /// Makes a node of items, the largest opened as long as there is room.
    std::uint32_t add_top(std::vector<Item> items, int depth) {
        depth_ = std::max(depth_, depth);
        for (;;) {
            Item* largest = nullptr;
            for (Item& item : items)
                if (item.can_open() &&
                    (largest == nullptr || item.box.half_area() > largest->box.half_area()))
                    largest = &item;
            if (largest == nullptr || items.size() == wide_children) break;
            const Item opened = *largest;
            *largest = child_of(opened, 0);
            items.push_back(child_of(opened, 1));
        }
        const std::uint32_t node = new_nodes(1);
        std::vector<Child> children;
        for (const Item& item : items) children.push_back({item.box, code_of(item, depth)});
        tree_.nodes[node] = make_node(children, tree_.max_coordinate);
        return node;
    }

    static Item child_of(const Item& item, std::size_t child) {
        const TreeNode& node = item.tree->nodes[item.ref.first];
        return {{{node.lo[0][child], node.lo[1][child], node.lo[2][child]},
                 {node.hi[0][child], node.hi[1][child], node.hi[2][child]}},
                item.tree,
                node.child[child],
                0};
    }

    std::uint32_t code_of(const Item& item, int depth) {
        if (item.tree == nullptr) return item.code;
        if (item.can_open()) return add_top({child_of(item, 0), child_of(item, 1)}, depth + 1);
        if (item.tree == &world_.quadric_tree)
            return 0x40000000u | (item.ref.count - 1) << 24 | item.ref.first;
        return 0x60000000u | world_.instances[item.tree->order[item.ref.first]].object;
    }

    const WorldData& world_;
    GpuTree tree_;
    int depth_ = 0;
};

} // namespace

GpuTree build_gpu_tree(const WorldData& world) { return Builder(world).run(); }

} // namespace glint::gpu
