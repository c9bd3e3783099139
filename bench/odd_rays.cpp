// glint-bench-odd-rays: cost of unusual rays, such as zero components or huge origins, relative to the
// ordinary rays they are made from.

#include "../tests/kit/temporary_folder.h"
#include "model.h"
#include "peer.h"
#include "rays.h"
#include "rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

namespace glint::bench {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t batch = 4096;
constexpr int rounds = 9;
constexpr int picture_size = 512;

/// A modification of a ray.
struct RayChange {
    const char* name;
    void (*apply)(Ray& ray);
};

template <int power>
void scale_direction(Ray& ray) {
    for (float& d : ray.direction) d = std::ldexp(d, power);
}

const RayChange changes[] = {
    {"NaN in the origin", [](Ray& ray) { ray.origin[1] = std::nanf(""); }},
    {"infinite origin", [](Ray& ray) { ray.origin[0] = -infinity; }},
    {"NaN in the direction", [](Ray& ray) { ray.direction[2] = std::nanf(""); }},
    {"infinite direction", [](Ray& ray) { ray.direction[0] = infinity; }},
    {"no direction",
     [](Ray& ray) {
         ray.direction = {0, 0, 0};
     }},
    {"tmin NaN", [](Ray& ray) { ray.tmin = std::nanf(""); }},
    {"tmax NaN", [](Ray& ray) { ray.tmax = std::nanf(""); }},
    {"tmin infinite", [](Ray& ray) { ray.tmin = infinity; }},
    {"tmax −infinite", [](Ray& ray) { ray.tmax = -infinity; }},
    {"tmin −infinite: the line on both sides", [](Ray& ray) { ray.tmin = -infinity; }},
    {"direction · 2⁻⁸⁰", scale_direction<-80>},
    {"direction · 2¹²⁰", scale_direction<120>},
    {"origin 2¹⁰⁰ away", [](Ray& ray) { ray.origin[1] += 0x1p100f; }},
};

double seconds_of(const Peer& peer, const std::vector<Ray>& rays, bool any, RayHint hint) {
    std::vector<Hit> hits(batch);
    std::vector<std::uint8_t> blocked(batch);
    const double start = thread_seconds();
    for (std::size_t first = 0; first < rays.size(); first += batch) {
        const std::size_t count = std::min(batch, rays.size() - first);
        if (any)
            peer.occluded({rays.data() + first, count}, {blocked.data(), count}, hint);
        else
            peer.closest({rays.data() + first, count}, {hits.data(), count}, hint);
    }
    return thread_seconds() - start;
}

/// Median over the rounds of the time of modified rays ÷ that of ordinary ones.
double cost(const Peer& peer, const std::vector<Ray>& plain, const std::vector<Ray>& odd, bool any,
            RayHint hint) {
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round)
        ratios.push_back(seconds_of(peer, odd, any, hint) / seconds_of(peer, plain, any, hint));
    return median(ratios);
}

int run(const std::vector<std::string>& files) {
    const test::TemporaryFolder folder;
    const Model model = files.empty() ? generate_model("knot", folder.path()) : load_model(files.front());
    const tracing::Mesh mesh = build_ours(model, tracing::BuildQuality::high, 1);
    const Peer peer = our_peer(mesh);
    const std::vector<Ray> plain = find_first_hits(model, mesh, picture_size).rays;
    fmt::print(
        "Modified rays through a picture of {0} × {0} pixels of {1}; CPU time relative to that of the "
        "original rays, medians of {2} rounds:\n\n"
        "| rays | closest, coherent | closest, incoherent | any, coherent | any, incoherent | one in 64 is "
        "|\n"
        "|---|---:|---:|---:|---:|---:|\n",
        picture_size, model.name, rounds);
    for (const RayChange& change : changes) {
        std::vector<Ray> all = plain;
        for (Ray& ray : all) change.apply(ray);
        std::vector<Ray> some = plain;
        for (std::size_t i = 0; i < some.size(); i += 64) change.apply(some[i]);
        fmt::print("| {} ", change.name);
        for (const bool any : {false, true})
            for (const RayHint hint : {RayHint::coherent, RayHint::incoherent})
                fmt::print("| {:.2f} ", cost(peer, plain, all, any, hint));
        fmt::print("| {:.2f} |\n", cost(peer, plain, some, false, RayHint::coherent));
    }
    return 0;
}

} // namespace
} // namespace glint::bench

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() > 1 || (!arguments.empty() && arguments[0].starts_with('-'))) {
        std::cerr << "usage: glint-bench-odd-rays [MESH.ply]   (without one: a knot of 70,000 triangles)\n";
        return !arguments.empty() && (arguments[0] == "--help" || arguments[0] == "-h") ? 0 : 2;
    }
    try {
        return glint::bench::run(arguments);
    } catch (const std::exception& error) {
        std::cerr << "glint-bench-odd-rays: " << error.what() << '\n';
        return 3;
    }
}
