#pragma once
// A tree over emitters, by which one is chosen in proportion to an estimate of the light that arrives from
// it. A. Conty Estevez and C. Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", Proc.
// ACM Comput. Graph. Interact. Tech. 1 (2), 2018.

#include "math/bounds.h"
#include "math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace glint::scene {

/// What the tree knows of an emitter, or of several together.
struct LightBounds {
    Bounds box;
    vec3 axis{0, 0, 1}; ///< unit: normals are within a cone about it
    float cos_cone = 1; ///< of half the cone's angle
    bool both_sides = false;
    float power = 0; ///< 0: never chosen
};

/// Where light arrives.
struct LightReceiver {
    vec3 p;
    vec3 n;                  ///< unit
    bool both_sides = false; ///< light from below n counts too
};

struct ChosenLight {
    std::uint32_t light = 0;
    float probability = 0; ///< 0: there is none
};

class LightTree {
  public:
    LightTree() = default;
    explicit LightTree(std::span<const LightBounds> lights);

    ChosenLight choose(const LightReceiver& at, float u) const;
    /// With which a light is chosen.
    float probability(std::uint32_t light, const LightReceiver& at) const;
    bool empty() const { return nodes_.empty(); }

  private:
    struct Node {
        LightBounds bounds;
        float sin_cone = 0;
        std::uint32_t right = 0; ///< the left child is the next node; 0 for a leaf
        std::uint32_t light = 0; ///< of a leaf
    };
    struct Builder;

    static float importance(const Node& node, const LightReceiver& at);
    float share_of_left(std::size_t node, const LightReceiver& at) const;

    std::vector<Node> nodes_;
    std::vector<std::uint64_t> turns_; ///< by light: bit i is 1 where the way down goes right at depth i
    std::vector<std::uint8_t> depth_;  ///< by light; that of lights that are never chosen is 255
};

} // namespace glint::scene
