#pragma once
// Timing in rounds. Peers alternate (A B C, then C B A), so that noise affects all alike. Times are CPU time
// of the working threads.

#include "jobs.h"

#include <vector>

namespace glint::bench {

struct Timing {
    double cpu = 0;  ///< seconds, all threads
    double wall = 0; ///< seconds
};

/// One peer runs the whole job `repeats` times on as many threads as there are result buffers in `results`,
/// each as large as job.empty_answers.
Timing time_once(const Job& job, const Peer& peer, std::vector<Answers>& results, std::size_t repeats = 1);

/// seconds[peer][round].
using Timings = std::vector<std::vector<Timing>>;

/// All peers on one thread.
Timings time_rounds(const Job& job, const std::vector<Peer>& peers, int rounds);

/// One peer on one thread and on two: [0] and [1]. Short jobs are repeated, so that starting threads is
/// negligible.
Timings time_threads(const Job& job, const Peer& peer, int rounds);

double median(std::vector<double> values);

/// CPU seconds of the calling thread, and of the whole process.
double thread_seconds();
double process_seconds();
double wall_seconds();

} // namespace glint::bench
