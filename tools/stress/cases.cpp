// The lists of families and of kernels.

#include "cases.h"

#include "families.h"
#include "stress_random.h"

#include <array>
#include <iterator>
#include <vector>

namespace glint::stress {
namespace {

/// A function of kind, seed and rays for one kind.
template <auto run, auto kind>
Tally run_case(std::uint64_t seed, std::uint32_t rays) {
    return run(kind, seed, rays);
}

} // namespace

std::span<const KernelVariant> kernel_variants() {
    static constexpr KernelVariant all[] = {
        {"auto", {}},
        {"scalar", {Kernel::scalar, SimdTarget::plain}},
        {"single plain", {Kernel::single, SimdTarget::plain}},
        {"single sse4", {Kernel::single, SimdTarget::sse4}},
        {"single avx2", {Kernel::single, SimdTarget::avx2}},
        {"single avx512", {Kernel::single, SimdTarget::avx512}},
        {"packet plain", {Kernel::packets, SimdTarget::plain}},
        {"packet sse4", {Kernel::packets, SimdTarget::sse4}},
        {"packet avx2", {Kernel::packets, SimdTarget::avx2}},
        {"packet avx512", {Kernel::packets, SimdTarget::avx512}},
        {"stream plain", {Kernel::streams, SimdTarget::plain}},
        {"stream sse4", {Kernel::streams, SimdTarget::sse4}},
        {"stream avx2", {Kernel::streams, SimdTarget::avx2}},
        {"stream avx512", {Kernel::streams, SimdTarget::avx512}},
    };
    static_assert(std::size(all) <= max_variants);
    static const std::vector<KernelVariant> here = [] {
        std::vector<KernelVariant> available;
        for (const KernelVariant& variant : all)
            if (is_available(variant.choice.target)) available.push_back(variant);
        return available;
    }();
    return here;
}

void Tally::add(const Tally& other) {
    rays += other.rays;
    hits += other.hits;
    on_edge += other.on_edge;
    failures += other.failures;
    for (std::size_t i = 0; i < by_variant.size(); ++i) by_variant[i] += other.by_variant[i];
    if (first_failure.empty()) first_failure = other.first_failure;
}

void Tally::fail(const std::string& what) {
    if (failures++ == 0) first_failure = what;
}

std::span<const Family> families() {
    static constexpr std::array all{
        Family{"soup", Property::agrees, run_case<run_soup, Soup::random>},
        Family{"needles", Property::agrees, run_case<run_soup, Soup::needles>},
        Family{"slivers", Property::agrees, run_case<run_soup, Soup::slivers>},
        Family{"axis-aligned", Property::agrees, run_case<run_soup, Soup::axis_aligned>},
        Family{"coplanar", Property::agrees, run_case<run_soup, Soup::coplanar>},
        Family{"duplicates", Property::agrees, run_case<run_soup, Soup::duplicates>},
        Family{"zero-area", Property::agrees, run_case<run_soup, Soup::zero_area>},
        Family{"quadrics", Property::agrees, run_case<run_soup, Soup::quadrics>},
        Family{"mixed", Property::agrees, run_case<run_soup, Soup::mixed>},
        Family{"instanced", Property::agrees, run_case<run_soup, Soup::instanced>},
        Family{"inside-icosphere", Property::closed, run_case<run_inside, Closed::icosphere>},
        Family{"inside-torus", Property::closed, run_case<run_inside, Closed::torus>},
        Family{"inside-polyhedron", Property::closed, run_case<run_inside, Closed::polyhedron>},
        Family{"through-icosphere", Property::crosses, run_case<run_through, Closed::icosphere>},
        Family{"through-torus", Property::crosses, run_case<run_through, Closed::torus>},
        Family{"through-polyhedron", Property::crosses, run_case<run_through, Closed::polyhedron>},
        Family{"through-knot", Property::crosses, run_case<run_through, Closed::knot>},
        Family{"within-polyhedron", Property::encloses, run_case<run_enclosed, Enclosed::polyhedron>},
        Family{"within-flat", Property::encloses, run_case<run_enclosed, Enclosed::flat>},
        Family{"within-faces", Property::encloses, run_case<run_enclosed, Enclosed::faces>},
        Family{"within-wide", Property::encloses, run_case<run_enclosed, Enclosed::wide>},
        Family{"within-torus", Property::encloses, run_case<run_enclosed, Enclosed::torus>},
        Family{"within-knot", Property::encloses, run_case<run_enclosed, Enclosed::knot>},
        Family{"within-icosphere", Property::encloses, run_case<run_enclosed, Enclosed::icosphere>},
        Family{"within-instance", Property::encloses, run_case<run_enclosed, Enclosed::instance>},
        Family{"within-quadric", Property::encloses, run_case<run_enclosed, Enclosed::quadric>},
    };
    return all;
}

std::uint64_t case_seed(std::uint64_t seed, std::uint64_t index) {
    Random outer(seed);
    Random inner(outer.bits() + index);
    return inner.bits();
}

} // namespace glint::stress
