#pragma once
// What path tracers sample of the lights of a scene: emitting surfaces, and how one of them is chosen.

#include "scene/light_tree.h"
#include "shading/emitter.shared.h"

#include <cstdint>
#include <span>
#include <vector>

namespace glint::scene {

struct SceneData;

/// Chooses one of several lights with probabilities in proportion to their weights.
class LightChoice {
  public:
    LightChoice() = default;
    /// Weights are at least 0; lights without weight are never chosen.
    explicit LightChoice(std::span<const double> weights);

    ChosenLight choose(float u) const;
    float probability(std::uint32_t light) const { return end_[light + 1] - end_[light]; }
    bool empty() const { return end_.empty() || !(end_.back() > 0.0f); }

  private:
    std::vector<float> end_; ///< of the intervals of [0, 1) that choose lights, after a 0
};

/// The lights of a scene.
struct LightSet {
    std::vector<EmitterRecord> emitters;
    std::vector<std::uint32_t> first_emitter; ///< of each object; of all its primitives in order, if it emits
    std::vector<std::uint8_t> is_one;         ///< by object: one emitter stands for all of its primitives
    LightTree tree;                           ///< of the emitters; empty if they are chosen alike or by power
    LightChoice choice;                       ///< of the emitters
    LightChoice points;                       ///< of SceneData::lights

    /// The emitter of a primitive; invalid_index where it is not sampled.
    std::uint32_t emitter_of(std::uint32_t object, std::uint32_t prim) const;
    /// Chooses an emitter for a point.
    ChosenLight choose(const LightReceiver& at, float u) const {
        return tree.empty() ? choice.choose(u) : tree.choose(at, u);
    }
    /// With which an emitter is chosen there.
    float probability(std::uint32_t emitter, const LightReceiver& at) const {
        return tree.empty() ? choice.probability(emitter) : tree.probability(emitter, at);
    }
};

/// Finds what emits in a scene whose world and materials are built.
LightSet find_lights(const SceneData& scene);

} // namespace glint::scene
