// Batches of random sizes by all kernels.

#include "batches.h"

#include <algorithm>
#include <bit>
#include <cstdio>
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
    Batches(const World& world, const ExpectedHits& expected, Random& random, Tally& tally)
        : world_(world), expected_(expected), random_(random), tally_(tally), hits_(expected.rays.size()),
          blocked_(expected.rays.size()) {}

    void check(std::size_t variant) {
        trace(kernel_variants()[variant].choice);
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            if (!same(hits_[i], expected_.hits[i]))
                fail(variant, i, "closest is " + describe(hits_[i]) + ", not " + describe(expected_.hits[i]));
            if (blocked_[i] != expected_.blocked[i]) fail(variant, i, "occluded differs");
            tally_.hits += hits_[i] ? 1 : 0;
            tally_.on_edge += hits_[i].on_edge ? 1 : 0;
        }
        tally_.rays += hits_.size();
        tally_.by_variant[variant] += hits_.size();
    }

  private:
    void trace(const KernelChoice& choice) {
        const std::span<const Ray> rays(expected_.rays);
        for (std::size_t at = 0; at < rays.size();) {
            const std::size_t max_rays = random_.one_in(4) ? 1 + random_.below(9) : 1 + random_.below(300);
            const std::size_t count = std::min(max_rays, rays.size() - at);
            const RayHint hint = random_.one_in(2) ? RayHint::coherent : RayHint::incoherent;
            world_.closest(rays.subspan(at, count), {hits_.data() + at, count}, hint, scratch_, choice);
            world_.occluded(rays.subspan(at, count), {blocked_.data() + at, count}, hint, scratch_, choice);
            at += count;
        }
    }

    void fail(std::size_t variant, std::size_t ray, const std::string& what) {
        tally_.fail(describe(expected_.rays[ray]) + ", " + kernel_variants()[variant].name +
                    " in batches: " + what);
    }

    const World& world_;
    const ExpectedHits& expected_;
    Random& random_;
    Tally& tally_;
    std::vector<Hit> hits_;
    std::vector<std::uint8_t> blocked_;
    World::Scratch scratch_;
};

} // namespace

std::string describe(const Ray& ray) {
    char text[320];
    std::snprintf(text, sizeof text, "origin (%a %a %a) direction (%a %a %a) tmin %a tmax %a",
                  double(ray.origin.x), double(ray.origin.y), double(ray.origin.z), double(ray.direction.x),
                  double(ray.direction.y), double(ray.direction.z), double(ray.tmin), double(ray.tmax));
    return text;
}

std::string describe(const trace::Hit& hit) {
    if (!hit) return "nothing";
    char text[160];
    std::snprintf(text, sizeof text, "t %a u %a v %a object %u prim %u kind %d%s", double(hit.t),
                  double(hit.u), double(hit.v), hit.object, hit.prim, static_cast<int>(hit.kind),
                  hit.on_edge ? " on an edge" : "");
    return text;
}

bool same(const Hit& a, const Hit& b) {
    return same_bits(a.t, b.t) && same_bits(a.u, b.u) && same_bits(a.v, b.v) && a.object == b.object &&
           a.prim == b.prim && a.kind == b.kind && a.on_edge == b.on_edge;
}

std::uint64_t rays_traced_once(std::uint64_t rays) { return rays / (1 + kernel_variants().size()); }

void check_batches(const World& world, const ExpectedHits& expected, Random& random, Tally& tally) {
    Batches batches(world, expected, random, tally);
    for (std::size_t variant = 0; variant < kernel_variants().size(); ++variant) batches.check(variant);
}

} // namespace glint::stress
