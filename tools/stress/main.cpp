// glint-stress: searches for rays that the tracing core gets wrong.

#include "cases.h"

#include "parallel/task_pool.h"

#include <charconv>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace glint;
using namespace glint::stress;

constexpr std::uint32_t rays_a_case = 24576;

struct Options {
    std::uint64_t rays = 10'000'000;
    int threads = 0;
    std::uint64_t seed = 1;
    std::string family;  ///< families whose names begin so
    bool replay = false; ///< `seed` is the seed of a single case
};

constexpr const char* usage =
    "usage: glint-stress [--rays N] [--threads T] [--seed S] [--family NAME [--replay CASE]]\n"
    "Traces N rays through degenerate and through closed meshes; exits 1 if any result is wrong.\n"
    "NAME is a family of worlds, or the beginning of several: 'within' for rays within closed solids.\n";

template <class T>
T number(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw std::invalid_argument("not a number: " + std::string(text));
    return value;
}

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view name = argv[i];
        if (i + 1 == argc) throw std::invalid_argument("no value for: " + std::string(name));
        const std::string_view value = argv[++i];
        if (name == "--rays")
            options.rays = number<std::uint64_t>(value);
        else if (name == "--threads")
            options.threads = number<int>(value);
        else if (name == "--seed")
            options.seed = number<std::uint64_t>(value);
        else if (name == "--family")
            options.family = value;
        else if (name == "--replay") {
            options.seed = number<std::uint64_t>(value);
            options.replay = true;
        } else
            throw std::invalid_argument("unknown option: " + std::string(name));
    }
    if (options.replay && options.family.empty()) throw std::invalid_argument("--replay needs --family");
    return options;
}

struct Outcome {
    Tally tally;
    std::uint64_t failing_case = 0;
};

/// Runs all cases of a family in parallel; outcomes are in case order.
Outcome run_family(const Family& family, std::uint64_t rays, const Options& options,
                   parallel::TaskPool& pool) {
    const std::uint64_t cases = options.replay ? 1 : (rays + rays_a_case - 1) / rays_a_case;
    std::vector<Outcome> by_worker(static_cast<std::size_t>(pool.threads()));
    pool.run(cases, [&](std::size_t index, int worker) {
        const std::uint64_t seed = options.replay ? options.seed : case_seed(options.seed, index);
        const Tally tally = family.run(seed, rays_a_case);
        Outcome& outcome = by_worker[static_cast<std::size_t>(worker)];
        if (tally.failures > 0 && outcome.tally.failures == 0) outcome.failing_case = seed;
        outcome.tally.add(tally);
    });
    Outcome sum;
    for (const Outcome& outcome : by_worker) {
        if (outcome.tally.failures > 0 && sum.tally.failures == 0) sum.failing_case = outcome.failing_case;
        sum.tally.add(outcome.tally);
    }
    return sum;
}

void print(const char* name, const Tally& tally) {
    std::printf("%-20s %14llu %14llu %14llu %10llu\n", name, static_cast<unsigned long long>(tally.rays),
                static_cast<unsigned long long>(tally.hits), static_cast<unsigned long long>(tally.on_edge),
                static_cast<unsigned long long>(tally.failures));
    std::fflush(stdout);
}

int run(const Options& options) {
    std::vector<Family> chosen;
    for (const Family& family : families())
        if (std::string_view(family.name).starts_with(options.family)) chosen.push_back(family);
    if (chosen.empty()) throw std::invalid_argument("no such family: " + options.family);

    parallel::TaskPool pool(options.threads);
    std::printf("%-20s %14s %14s %14s %10s\n", "family", "rays", "hits", "on an edge", "failures");
    Tally total;
    for (const Family& family : chosen) {
        const Outcome outcome = run_family(family, options.rays / chosen.size(), options, pool);
        print(family.name, outcome.tally);
        if (outcome.tally.failures > 0)
            std::printf("  %s\n  to repeat: glint-stress --family %s --replay %llu\n",
                        outcome.tally.first_failure.c_str(), family.name,
                        static_cast<unsigned long long>(outcome.failing_case));
        total.add(outcome.tally);
    }
    print("all", total);
    std::printf("\nof these, in batches by kernel and SIMD target:\n");
    for (std::size_t i = 0; i < kernel_variants().size(); ++i)
        std::printf("%-20s %14llu\n", kernel_variants()[i].name,
                    static_cast<unsigned long long>(total.by_variant[i]));
    return total.failures > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--help") == 0) {
        std::fputs(usage, stdout);
        return 0;
    }
    try {
        return run(parse(argc, argv));
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "glint-stress: %s\n%s", error.what(), usage);
        return 2;
    }
}
