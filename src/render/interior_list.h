#pragma once
// Nested dielectrics: the transparent solids around a ray. The one of the highest rank owns the space;
// surfaces of the others inside it are skipped, opaque surfaces and panes never are. C. M. Schmidt and B.
// Budge, "Simple Nested Dielectrics in Ray Traced Images", Journal of Graphics Tools 7 (2), 2002.

#include "scene/scene_data.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace glint::rendering {

/// Immutable, so that the branches of a ray tree can share lists. Null: no solid is around the ray.
struct InteriorList {
    std::uint32_t object = 0; ///< entered last
    std::uint32_t owner = 0;  ///< of the object and the rest the one of the highest rank
    const InteriorList* rest = nullptr;
};

/// Memory for the lists of one ray tree; clear() invalidates them all.
class InteriorArena {
  public:
    const InteriorList* push(const InteriorList& entry) {
        if (used_ == blocks_.size() * block_size) blocks_.push_back(std::make_unique<Block>());
        InteriorList& cell = (*blocks_[used_ / block_size])[used_ % block_size];
        ++used_;
        cell = entry;
        return &cell;
    }
    void clear() { used_ = 0; }

    /// Invalidates at its end the lists made since its beginning.
    class Scope {
      public:
        explicit Scope(InteriorArena& arena) : arena_(arena), used_(arena.used_) {}
        ~Scope() { arena_.used_ = used_; }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        InteriorArena& arena_;
        std::size_t used_;
    };

  private:
    static constexpr std::size_t block_size = 64;
    using Block = std::array<InteriorList, block_size>;
    std::vector<std::unique_ptr<Block>> blocks_;
    std::size_t used_ = 0;
};

/// True for transparent solids; only those can be in a list.
bool is_dielectric(std::uint32_t object, const scene::SceneData& scene);

/// The list with `object` added.
const InteriorList* entered(const InteriorList* list, std::uint32_t object, const scene::SceneData& scene,
                            InteriorArena& arena);

/// The list without the latest entry of `object`; the same list if it has none. Copies what was entered
/// since: nothing, where solids lie in each other.
const InteriorList* left(const InteriorList* list, std::uint32_t object, const scene::SceneData& scene,
                         InteriorArena& arena);

/// The list behind a surface of `object`: entered() where `entering`, else left().
const InteriorList* crossed(const InteriorList* list, std::uint32_t object, bool entering,
                            const scene::SceneData& scene, InteriorArena& arena);

/// True for the surface of a transparent solid inside one of higher rank: rays skip it.
bool is_hidden(const InteriorList* list, std::uint32_t object, const scene::SceneData& scene);

/// The index of refraction inside all solids of the list: that of the owner.
float refractive_index(const InteriorList* list, const scene::SceneData& scene);

/// The objects of the list, highest rank first.
std::vector<std::uint32_t> solids_of(const InteriorList* list, const scene::SceneData& scene);

} // namespace glint::rendering
