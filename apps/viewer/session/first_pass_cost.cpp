// The cost model of first passes: two exponential moving averages.
#include "first_pass_cost.h"

#include "glint/progressive.h"

#include <algorithm>

namespace glint::viewer {
namespace {

double samples(int pixels, int step) { return static_cast<double>(pixels) / (step * step); }

/// Moves an average towards a measurement. One late picture does not make the next ones coarse: the machine
/// may have been busy otherwise.
void update(double& average, double measured) {
    constexpr double weight = 0.25;
    constexpr double max_growth = 4;
    average += weight * (std::min(measured, max_growth * average) - average);
}

} // namespace

int FirstPassCost::step(int pixels) const {
    int step = 1;
    while (step < max_coarsest && predicted_seconds(pixels, step) > seconds_) step *= 2;
    return step;
}

void FirstPassCost::learn(int pixels, int step, double trace_seconds, double show_seconds) {
    update(seconds_per_sample_, trace_seconds / std::max(1.0, samples(pixels, step)));
    update(seconds_per_pixel_, show_seconds / pixels);
}

double FirstPassCost::predicted_seconds(int pixels, int step) const {
    return samples(pixels, step) * seconds_per_sample_ + pixels * seconds_per_pixel_;
}

} // namespace glint::viewer
