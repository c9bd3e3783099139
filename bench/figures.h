#pragma once
// Medians and ratios of what was measured.

#include "report.h"

namespace glint::bench {

/// Mrays a CPU second: the median over the rounds.
double median_rate(const SetResult& set, std::size_t peer);

/// The fastest peer of a group by median_rate(); 0, ours, where the group has none.
std::size_t best_of(const SetResult& set, Group group);

/// The median over the rounds of our rate ÷ the peer's; 0 for ourselves.
double median_ratio(const SetResult& set, std::size_t peer);

double geometric_mean(const std::vector<double>& values);

/// Ours on two threads against one, a wall second. Only rounds that had two cores tell: CPU ÷ wall ≥ 1.9.
struct ThreadFigures {
    double one = 0; ///< Mrays a wall second
    double two = 0;
    double ratio = 0; ///< 0 where no round had two cores
    double cores = 0; ///< CPU ÷ wall, median of all rounds
    std::size_t full_rounds = 0;
    std::size_t rounds = 0;
};
ThreadFigures thread_figures(const SetResult& set);

/// Medians of a builder: Mtri a CPU second, bytes a triangle, and the ratio of its rate to that of Embree's
/// builder of the same purpose, 0 where there is none.
struct BuildMedians {
    double rate = 0;
    double ratio = 0;
    double own = 0;
    double held = 0;
    double peak = 0;
};
BuildMedians build_medians(const ModelResult& model, std::size_t builder);

} // namespace glint::bench
