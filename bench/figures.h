#pragma once
// Medians and ratios of the measurements.

#include "report.h"

namespace glint::bench {

/// Median over the rounds of Mrays per CPU second.
double median_rate(const SetResult& set, std::size_t peer);

/// Index of the fastest peer of a group by median_rate(); 0, which is glint, if the group is empty.
std::size_t best_of(const SetResult& set, Group group);

/// Median over the rounds of glint's rate ÷ the peer's; 0 for glint itself.
double median_ratio(const SetResult& set, std::size_t peer);

double geometric_mean(const std::vector<double>& values);

/// glint on two threads against one, in wall time. Only rounds that really had two cores count: CPU ÷ wall ≥
/// 1.9.
struct ThreadFigures {
    double one = 0; ///< Mrays a wall second
    double two = 0;
    double ratio = 0; ///< 0 if no round had two cores
    double cores = 0; ///< CPU ÷ wall, median of all rounds
    std::size_t full_rounds = 0;
    std::size_t rounds = 0;
};
ThreadFigures thread_figures(const SetResult& set);

/// Medians of a builder: Mtri per CPU second, bytes a triangle, and the ratio of its rate to that of Embree's
/// corresponding builder, 0 if there is none.
struct BuildMedians {
    double rate = 0;
    double ratio = 0;
    double own = 0;
    double held = 0;
    double peak = 0;
};
BuildMedians build_medians(const ModelResult& model, std::size_t builder);

} // namespace glint::bench
