// Subdivided icosahedra.

#include "geometry/polyhedron.h"
#include "shapes.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace glint::meshgen {
namespace {

using Index = std::uint32_t;

// Midpoints of edges, created once for both adjacent triangles.
class Midpoints {
  public:
    explicit Midpoints(std::vector<dvec3>& positions) : positions_(positions) {}

    Index between(Index a, Index b) {
        const auto [it, is_new] = made_.try_emplace(std::minmax(a, b), static_cast<Index>(positions_.size()));
        if (is_new) positions_.push_back(glm::normalize(positions_[a] + positions_[b]));
        return it->second;
    }

  private:
    std::vector<dvec3>& positions_;
    std::map<std::pair<Index, Index>, Index> made_;
};

} // namespace

Mesh make_icosphere(int levels) {
    geometry::Polyhedron ball = geometry::make_icosahedron(dvec3(0), 1);
    for (int level = 0; level < levels; ++level) {
        Midpoints middle(ball.positions);
        std::vector<uvec3> finer;
        for (const uvec3& t : ball.triangles) {
            const Index ab = middle.between(t.x, t.y);
            const Index bc = middle.between(t.y, t.z);
            const Index ca = middle.between(t.z, t.x);
            finer.insert(finer.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
        }
        ball.triangles = std::move(finer);
    }
    Mesh mesh;
    for (const dvec3& p : ball.positions) mesh.positions.emplace_back(p);
    mesh.triangles = std::move(ball.triangles);
    return mesh;
}

} // namespace glint::meshgen
