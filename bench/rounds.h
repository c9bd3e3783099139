#pragma once
// Peers take turns: A B C, then C B A, so that noise hits all alike. Time is CPU time of the working threads.

#include "jobs.h"

#include <vector>

namespace glint::bench {

struct Timing {
    double cpu = 0;  ///< seconds, all threads
    double wall = 0; ///< seconds
};

/// One peer does the whole job once. Answers are as large as job.room.
Timing time_once(const Job& job, const Peer& peer, int threads, Answers& answers);

/// seconds[peer][round].
using Timings = std::vector<std::vector<Timing>>;

/// All peers on one thread.
Timings time_rounds(const Job& job, const std::vector<Peer>& peers, int rounds);

/// One peer on one thread and on two: [0] and [1].
Timings time_threads(const Job& job, const Peer& peer, int rounds);

double median(std::vector<double> values);

/// CPU seconds of the calling thread, and of the whole process.
double thread_seconds();
double process_seconds();
double wall_seconds();

} // namespace glint::bench
