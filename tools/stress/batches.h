#pragma once
// Comparing and describing hits, and tracing rays again in batches with every kernel.

#include "cases.h"
#include "stress_random.h"
#include "trace/world/world.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glint::stress {

/// All numbers of a ray or hit as hexadecimal floats.
std::string describe(const Ray& ray);
std::string describe(const trace::Hit& hit);

/// Whether two hits are bitwise equal.
bool same(const trace::Hit& a, const trace::Hit& b);

/// Rays with their expected results.
struct ExpectedHits {
    std::vector<Ray> rays;
    std::vector<trace::Hit> hits;
    std::vector<std::uint8_t> blocked;

    void add(const Ray& ray, const trace::Hit& hit, bool is_blocked) {
        rays.push_back(ray);
        hits.push_back(hit);
        blocked.push_back(is_blocked ? 1 : 0);
    }
};

/// Number of rays to trace singly, so that with the repetitions by kernel_variants() the case traces `rays`
/// in total.
std::uint64_t rays_traced_once(std::uint64_t rays);

/// Traces all rays again by each of kernel_variants(), in batches of random sizes with random hints, and
/// counts differences.
void check_batches(const trace::World& world, const ExpectedHits& expected, Random& random, Tally& tally);

} // namespace glint::stress
