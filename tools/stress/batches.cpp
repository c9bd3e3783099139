// Batches of random sizes by all kernels.

#include "batches.h"

#include "describe.h"

#include <algorithm>
#include <bit>
#include <span>

namespace glint::stress {

using trace::Hit;
using trace::World;

namespace {

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Traces all rays of a world in batches.
class Batches {
  public:
    Batches(const World& world, const Answered& answered, Random& random, Tally& tally)
        : world_(world), answered_(answered), random_(random), tally_(tally), hits_(answered.rays.size()),
          blocked_(answered.rays.size()) {}

    void check(std::size_t way) {
        trace(ways()[way].choice);
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            if (!same(hits_[i], answered_.hits[i]))
                fail(way, i, "closest is " + describe(hits_[i]) + ", not " + describe(answered_.hits[i]));
            if (blocked_[i] != answered_.blocked[i]) fail(way, i, "occluded differs");
            tally_.hits += hits_[i] ? 1 : 0;
            tally_.on_edge += hits_[i].on_edge ? 1 : 0;
        }
        tally_.rays += hits_.size();
        tally_.by_way[way] += hits_.size();
    }

  private:
    void trace(const KernelChoice& choice) {
        const std::span<const Ray> rays(answered_.rays);
        for (std::size_t at = 0; at < rays.size();) {
            const std::size_t most = random_.one_in(4) ? 1 + random_.below(9) : 1 + random_.below(300);
            const std::size_t count = std::min(most, rays.size() - at);
            const RayHint hint = random_.one_in(2) ? RayHint::coherent : RayHint::incoherent;
            world_.closest(rays.subspan(at, count), {hits_.data() + at, count}, hint, scratch_, choice);
            world_.occluded(rays.subspan(at, count), {blocked_.data() + at, count}, hint, scratch_, choice);
            at += count;
        }
    }

    void fail(std::size_t way, std::size_t ray, const std::string& what) {
        tally_.fail(describe(answered_.rays[ray]) + ", " + ways()[way].name + " in batches: " + what);
    }

    const World& world_;
    const Answered& answered_;
    Random& random_;
    Tally& tally_;
    std::vector<Hit> hits_;
    std::vector<std::uint8_t> blocked_;
    World::Scratch scratch_;
};

} // namespace

bool same(const Hit& a, const Hit& b) {
    return same_bits(a.t, b.t) && same_bits(a.u, b.u) && same_bits(a.v, b.v) && a.object == b.object &&
           a.prim == b.prim && a.kind == b.kind && a.on_edge == b.on_edge;
}

std::uint64_t rays_traced_once(std::uint64_t rays) { return rays / (1 + ways().size()); }

void check_batches(const World& world, const Answered& answered, Random& random, Tally& tally) {
    Batches batches(world, answered, random, tally);
    for (std::size_t way = 0; way < ways().size(); ++way) batches.check(way);
}

} // namespace glint::stress
