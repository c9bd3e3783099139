#pragma once
// The same rays once more, many at a time and by every kernel.

#include "cases.h"
#include "stress_random.h"
#include "trace/world.h"

#include <cstdint>
#include <vector>

namespace glint::stress {

/// Do all numbers of two hits have the same bits?
bool same(const Hit& a, const Hit& b);

/// Rays with the answers that they must get.
struct Answered {
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<std::uint8_t> blocked;

    void add(const Ray& ray, const Hit& hit, bool is_blocked) {
        rays.push_back(ray);
        hits.push_back(hit);
        blocked.push_back(is_blocked ? 1 : 0);
    }
};

/// How many of a case's rays to trace alone, when each of ways() traces them again.
std::uint64_t rays_traced_once(std::uint64_t rays);

/// Asks for all of them again, by each of ways() in batches of random sizes with random hints, and counts
/// what differs.
void check_batches(const World& world, const Answered& answered, Random& random, Tally& tally);

} // namespace glint::stress
