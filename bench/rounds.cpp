// Timing of jobs.

#include "rounds.h"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <thread>

namespace glint::bench {
namespace {

/// Minimum CPU time of a job for thread scaling; shorter ones are repeated.
constexpr double min_seconds = 0.4;

double seconds_of(clockid_t clock) {
    timespec time;
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }
double process_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

Timing time_once(const Job& job, const Peer& peer, std::vector<Answers>& results, std::size_t repeats) {
    std::atomic<std::size_t> next{0};
    std::vector<double> cpu(results.size());
    const auto work = [&](std::size_t worker) {
        const double start = thread_seconds();
        for (std::size_t task = next++; task < job.batches * repeats; task = next++)
            job.run(peer, task % job.batches, results[worker]);
        cpu[worker] = thread_seconds() - start;
    };
    const double start = wall_seconds();
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < cpu.size(); ++i) helpers.emplace_back([&, i] { work(i); });
    work(0);
    for (std::thread& helper : helpers) helper.join();
    Timing timing{0, wall_seconds() - start};
    for (const double seconds : cpu) timing.cpu += seconds;
    return timing;
}

Timings time_rounds(const Job& job, const std::vector<Peer>& peers, int rounds) {
    Timings timings(peers.size());
    std::vector<Answers> results{job.empty_answers};
    for (const Peer& peer : peers) time_once(job, peer, results);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t turn = 0; turn < peers.size(); ++turn) {
            const std::size_t peer = round % 2 == 0 ? turn : peers.size() - 1 - turn;
            timings[peer].push_back(time_once(job, peers[peer], results));
        }
    return timings;
}

Timings time_threads(const Job& job, const Peer& peer, int rounds) {
    Timings timings(2);
    std::vector<Answers> one{job.empty_answers};
    std::vector<Answers> two{job.empty_answers, job.empty_answers};
    const double once = time_once(job, peer, one).cpu;
    const std::size_t repeats = once < min_seconds ? static_cast<std::size_t>(min_seconds / once) + 1 : 1;
    const auto time = [&](std::vector<Answers>& results) {
        Timing timing = time_once(job, peer, results, repeats);
        timing.cpu /= static_cast<double>(repeats);
        timing.wall /= static_cast<double>(repeats);
        timings[results.size() - 1].push_back(timing);
    };
    for (int round = 0; round < rounds; ++round) {
        time(round % 2 == 0 ? one : two);
        time(round % 2 == 0 ? two : one);
    }
    return timings;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

} // namespace glint::bench
