#pragma once
// The solids that a ray is in: an immutable list, highest rank first, shared by the branches of a ray tree.

#include "scene/frozen.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace glint {

/// One transparent solid around a ray; the head of the list owns the space.
struct Media {
    std::uint32_t object = 0;
    const Media* rest = nullptr;
};

/// Memory for lists of one ray tree; clear() forgets them all.
class MediaArena {
  public:
    const Media* push(std::uint32_t object, const Media* rest) {
        if (used_ == blocks_.size() * block_size) blocks_.push_back(std::make_unique<Block>());
        Media& cell = (*blocks_[used_ / block_size])[used_ % block_size];
        ++used_;
        cell = Media{object, rest};
        return &cell;
    }
    void clear() { used_ = 0; }

  private:
    static constexpr std::size_t block_size = 64;
    using Block = std::array<Media, block_size>;
    std::vector<std::unique_ptr<Block>> blocks_;
    std::size_t used_ = 0;
};

/// The list with `object` added at its rank.
const Media* with(const Media* list, std::uint32_t object, const FrozenScene& scene, MediaArena& arena);

/// The list without one entry of `object`; the same list if it has none.
const Media* without(const Media* list, std::uint32_t object, MediaArena& arena);

/// The list beyond a surface of `object`: entered where `entering`, else left.
const Media* across(const Media* list, std::uint32_t object, bool entering, const FrozenScene& scene,
                    MediaArena& arena);

/// Is a surface of `object` hidden inside a transparent solid of higher rank?
bool hidden(const Media* list, std::uint32_t object, const FrozenScene& scene);

/// The index of refraction where the list holds.
float index_of(const Media* list, const FrozenScene& scene);

} // namespace glint
