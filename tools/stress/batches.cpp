#include "batches.h"

#include "describe.h"

#include <algorithm>
#include <bit>
#include <span>

namespace glint::stress {

namespace {

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

} // namespace

bool same(const Hit& a, const Hit& b) {
    return same_bits(a.t, b.t) && same_bits(a.u, b.u) && same_bits(a.v, b.v) && a.object == b.object &&
           a.prim == b.prim && a.kind == b.kind && a.on_edge == b.on_edge;
}

void check_batches(const World& world, const Answered& answered, Random& random, Tally& tally) {
    const std::span<const Ray> rays(answered.rays);
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    World::Scratch scratch;
    for (std::size_t at = 0; at < rays.size();) {
        const std::size_t most = random.one_in(4) ? 1 + random.below(9) : 1 + random.below(300);
        const std::size_t count = std::min(most, rays.size() - at);
        const RayHint hint = random.one_in(2) ? RayHint::coherent : RayHint::incoherent;
        world.closest(rays.subspan(at, count), {hits.data() + at, count}, hint, scratch);
        world.occluded(rays.subspan(at, count), {blocked.data() + at, count}, hint, scratch);
        at += count;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!same(hits[i], answered.hits[i]))
            tally.fail(describe(rays[i]) + ": closest of a batch is " + describe(hits[i]) + ", not " +
                       describe(answered.hits[i]));
        if (blocked[i] != answered.blocked[i])
            tally.fail(describe(rays[i]) + ": occluded of a batch differs");
    }
    tally.rays += rays.size();
}

} // namespace glint::stress
