// Medians and ratios.

#include "figures.h"

#include <cmath>

namespace glint::bench {
namespace {

/// Median over the rounds of value(round).
template <class Value>
double median_over(std::size_t rounds, Value&& value) {
    std::vector<double> values;
    for (std::size_t round = 0; round < rounds; ++round) values.push_back(value(round));
    return median(std::move(values));
}

/// Name of Embree's builder that corresponds to one of glint's; empty if there is none.
std::string opponent(const std::string& builder) {
    if (builder == "glint fast") return "Embree MEDIUM";
    if (builder == "glint high") return "Embree HIGH";
    return "";
}

} // namespace

double median_rate(const SetResult& set, std::size_t peer) {
    const auto& rounds = set.timings[peer];
    return median_over(rounds.size(),
                       [&](std::size_t r) { return 1e-6 * static_cast<double>(set.rays) / rounds[r].cpu; });
}

std::size_t best_of(const SetResult& set, Group group) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < set.peers.size(); ++i)
        if (set.peers[i].group == group && (best == 0 || median_rate(set, i) > median_rate(set, best)))
            best = i;
    return best;
}

double median_ratio(const SetResult& set, std::size_t peer) {
    if (peer == 0) return 0;
    const auto& ours = set.timings[0];
    const auto& theirs = set.timings[peer];
    return median_over(ours.size(), [&](std::size_t r) { return theirs[r].cpu / ours[r].cpu; });
}

double geometric_mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

ThreadFigures thread_figures(const SetResult& set) {
    const auto& one = set.threads[0];
    const auto& two = set.threads[1];
    const double mrays = 1e-6 * static_cast<double>(set.rays);
    ThreadFigures found;
    found.rounds = one.size();
    found.one = median_over(one.size(), [&](std::size_t r) { return mrays / one[r].wall; });
    found.two = median_over(two.size(), [&](std::size_t r) { return mrays / two[r].wall; });
    found.cores = median_over(two.size(), [&](std::size_t r) { return two[r].cpu / two[r].wall; });
    std::vector<double> ratios;
    for (std::size_t r = 0; r < two.size(); ++r)
        if (two[r].cpu >= 1.9 * two[r].wall) ratios.push_back(one[r].wall / two[r].wall);
    found.full_rounds = ratios.size();
    found.ratio = median(std::move(ratios));
    return found;
}

BuildMedians build_medians(const ModelResult& model, std::size_t builder) {
    const auto& rounds = model.builds[builder].rounds;
    const auto triangles = static_cast<double>(model.triangles);
    const auto each = [&](auto member) {
        return median_over(rounds.size(),
                           [&](std::size_t r) { return static_cast<double>(rounds[r].*member) / triangles; });
    };
    BuildMedians found;
    found.rate = median_over(rounds.size(), [&](std::size_t r) { return 1e-6 * triangles / rounds[r].cpu; });
    found.own = each(&BuildFigures::own_bytes);
    found.held = each(&BuildFigures::held_bytes);
    found.peak = each(&BuildFigures::peak_bytes);
    for (const BuildResult& other : model.builds)
        if (other.builder == opponent(model.builds[builder].builder))
            found.ratio = median_over(rounds.size(),
                                      [&](std::size_t r) { return other.rounds[r].cpu / rounds[r].cpu; });
    return found;
}

} // namespace glint::bench
