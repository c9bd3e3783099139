#pragma once
// Which boxes touch.

#include "bvh/traverse.h"
#include "parallel/task_pool.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace glint::scene {

/// A tree over the finite boxes of objects.
class BoxTree {
  public:
    /// box_of(id) gives the box of an object.
    template <class BoxOf>
    BoxTree(std::span<const std::uint32_t> ids, BoxOf&& box_of, parallel::TaskPool& pool) {
        for (const std::uint32_t id : ids) {
            const Bounds box = box_of(id);
            boxes_.push_back({box.lo, static_cast<std::uint32_t>(boxes_.size()), box.hi});
            ids_.push_back(id);
        }
        tree_ = bvh::build_tree(boxes_, max_leaf, pool);
    }

    /// Whether a box touches one of the tree.
    bool touches(const Bounds& box) const {
        bool found = false;
        visit_touching(box, [&](std::uint32_t) { return found = true; });
        return found;
    }

    /// Calls visit(a, b) once for each pair, a before b in the order of the ids given.
    template <class Visit>
    void visit_pairs(Visit&& visit) const {
        for (std::uint32_t i = 0; i < boxes_.size(); ++i)
            visit_touching({boxes_[i].lo, boxes_[i].hi}, [&](std::uint32_t k) {
                if (i < k) visit(ids_[i], ids_[k]);
                return false;
            });
    }

  private:
    static constexpr std::uint32_t max_leaf = 4;

    /// Calls visit(index of a box) until it returns true.
    template <class Visit>
    void visit_touching(const Bounds& box, Visit&& visit) const {
        const float limit = 0;
        const auto enter = [&](std::uint32_t node, float(&entries)[2]) {
            for (std::size_t child = 0; child < 2; ++child)
                entries[child] = touch(bvh::child_box(tree_.nodes[node], child), box)
                                     ? 0
                                     : std::numeric_limits<float>::infinity();
        };
        bvh::traverse_below(tree_, tree_.root, limit, enter, [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t at = first; at < first + count; ++at) {
                const bvh::BoxRef& other = boxes_[tree_.order[at]];
                if (touch({other.lo, other.hi}, box) && visit(other.id)) return true;
            }
            return false;
        });
    }

    std::vector<bvh::BoxRef> boxes_;
    std::vector<std::uint32_t> ids_; ///< by box
    bvh::Tree tree_;
};

} // namespace glint::scene
