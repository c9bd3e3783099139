#pragma once
// What a shape is made of: the parts that shapes hand to the tracing core, and the helpers they share.

#include "geometry/quadric.h"
#include "glint/scene.h"
#include "scene/bake_mesh.h"
#include "scene/keys/check.h"
#include "scene/names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace glint::scene {

/// A box in double around a shape, in the shape's own space.
struct ShapeBox {
    dvec3 lo{std::numeric_limits<double>::infinity()};
    dvec3 hi{-std::numeric_limits<double>::infinity()};

    bool empty() const { return lo.x > hi.x; }
    void grow(const dvec3& p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
};

/// What support() gives for shapes without a finite point.
inline constexpr double no_support = -std::numeric_limits<double>::infinity();

/// Raises `most` to d · p; points that are not finite do not count.
inline void raise_support(double& most, const dvec3& d, const dvec3& p) {
    const double along = glm::dot(d, p);
    if (std::isfinite(along)) most = std::max(most, along);
}

/// What is wrong with a shape though each of its keys is good: nothing, for most.
template <class S>
std::optional<KeyFault> shape_fault(const S&) {
    return std::nullopt;
}

/// Adds the parts of one object to the input of the tracing core: they come in the shape's space, and the
/// object's transform is applied in double and rounded once.
class ShapeBaker {
  public:
    /// All must outlive this.
    ShapeBaker(const NameIndex& names, const Object& object, std::uint32_t id, Baked& baked,
               MeshBaker& meshes)
        : names_(names), object_(object), id_(id), baked_(baked), meshes_(meshes) {}

    /// All p with normal · p = offset.
    void plane(const dvec3& normal, double offset);
    /// It is moved where the transform keeps angles, else solved in its own space.
    void quadric(const QuadricShape& shape);
    /// `closed`: they bound a volume.
    void triangles(const std::vector<dvec3>& positions, std::vector<uvec3> triangles, bool closed);
    /// The object's own mesh.
    void mesh();
    /// The mesh of the object with that name: by its own scale and transform first.
    void instance(const std::string& name);

  private:
    const NameIndex& names_;
    const Object& object_;
    std::uint32_t id_;
    Baked& baked_;
    MeshBaker& meshes_;
};

} // namespace glint::scene
