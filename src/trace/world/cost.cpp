// Cost of closest-hit queries, counted in scalar traversal: the work of SIMD kernels depends on the machine.

#include "trace/world/data.h"

namespace glint::trace {
namespace {

/// A query that counts its steps.
class CountedSearch {
  public:
    CountedSearch(const WorldData& world, const Ray& ray)
        : world_(world), ray_(ray), nearest_{limit_below(ray.tmax)} {}

    TraceCost run() {
        search_surfaces();
        search_mesh(world_.mesh_tree, ray_, TriangleTester<Closest>(world_, ray_, nearest_));
        search_mesh(world_.wide_tree, ray_, WideTester<Closest>(world_, ray_, nearest_));
        world_.instance_tree.visit(ray_, nearest_.limit, [&](std::uint32_t instance) {
            ++cost_.nodes;
            const Ray local = world_.instance_tree.to_local(instance, ray_);
            if (is_traceable(local))
                search_mesh(world_.instance_tree.mesh(instance), local,
                            TriangleTester<Closest>(world_, local, nearest_, instance));
            return false;
        });
        return cost_;
    }

  private:
    void search_surfaces() {
        QuadricTester<Closest> test(world_, ray_, nearest_);
        cost_.shapes += static_cast<std::uint32_t>(world_.planes.size());
        test.planes();
        const auto quadrics = [&](std::uint32_t first, std::uint32_t count) {
            cost_.shapes += count;
            return test.quadrics(first, count);
        };
        const Tree& tree = world_.quadric_tree;
        if (tree.nodes.empty()) {
            quadrics(0, static_cast<std::uint32_t>(world_.quadrics.size()));
            return;
        }
        traverse(tree, BoxRay(ray_, tree.bounds), ray_.tmin, nearest_.limit, quadrics,
                 [&] { ++cost_.nodes; });
    }

    template <class Tester>
    void search_mesh(const MeshTree& tree, const Ray& ray, Tester test) {
        const auto triangles = [&](LeafCode leaf) {
            cost_.shapes += leaf.triangles();
            return test.leaf(tree, leaf);
        };
        walk(tree, ray, ray.tmin, nearest_.limit, triangles, [&] { ++cost_.nodes; });
    }

    const WorldData& world_;
    const Ray& ray_;
    Closest nearest_;
    TraceCost cost_;
};

} // namespace

TraceCost World::cost(const Ray& ray) const {
    return is_traceable(ray) ? CountedSearch(*data_, ray).run() : TraceCost{};
}

} // namespace glint::trace
