#pragma once
// Cases of Claim::agrees: trees give the results of brute force.

#include "cases.h"
#include "soups.h"

namespace glint::stress {

Tally run_soup(Soup kind, std::uint64_t seed, std::uint32_t rays);

template <Soup kind>
Tally soup_agrees(std::uint64_t seed, std::uint32_t rays) {
    return run_soup(kind, seed, rays);
}

} // namespace glint::stress
