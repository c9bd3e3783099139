// The list of families.

#include "cases.h"

#include "closed_cases.h"
#include "soup_cases.h"
#include "stress_random.h"

#include <array>

namespace glint::stress {

void Tally::add(const Tally& other) {
    rays += other.rays;
    hits += other.hits;
    on_edge += other.on_edge;
    failures += other.failures;
    for (std::size_t i = 0; i < by_way.size(); ++i) by_way[i] += other.by_way[i];
    if (first_failure.empty()) first_failure = other.first_failure;
}

void Tally::fail(const std::string& what) {
    if (failures++ == 0) first_failure = what;
}

std::span<const Family> families() {
    static constexpr std::array all{
        Family{"soup", Claim::agrees, soup_agrees<Soup::random>},
        Family{"needles", Claim::agrees, soup_agrees<Soup::needles>},
        Family{"slivers", Claim::agrees, soup_agrees<Soup::slivers>},
        Family{"axis-aligned", Claim::agrees, soup_agrees<Soup::axis_aligned>},
        Family{"coplanar", Claim::agrees, soup_agrees<Soup::coplanar>},
        Family{"duplicates", Claim::agrees, soup_agrees<Soup::duplicates>},
        Family{"zero-area", Claim::agrees, soup_agrees<Soup::zero_area>},
        Family{"quadrics", Claim::agrees, soup_agrees<Soup::quadrics>},
        Family{"mixed", Claim::agrees, soup_agrees<Soup::mixed>},
        Family{"instanced", Claim::agrees, soup_agrees<Soup::instanced>},
        Family{"inside-icosphere", Claim::closed, inside_hits<Closed::icosphere>},
        Family{"inside-torus", Claim::closed, inside_hits<Closed::torus>},
        Family{"inside-polyhedron", Claim::closed, inside_hits<Closed::polyhedron>},
        Family{"through-icosphere", Claim::crosses, crosses_evenly<Closed::icosphere>},
        Family{"through-torus", Claim::crosses, crosses_evenly<Closed::torus>},
        Family{"through-polyhedron", Claim::crosses, crosses_evenly<Closed::polyhedron>},
        Family{"through-knot", Claim::crosses, crosses_evenly<Closed::knot>},
    };
    return all;
}

std::uint64_t case_seed(std::uint64_t seed, std::uint64_t index) {
    Random outer(seed);
    Random inner(outer.bits() + index);
    return inner.bits();
}

} // namespace glint::stress
