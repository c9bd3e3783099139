#include "rounds.h"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <thread>

namespace glint::bench {
namespace {

double seconds_of(clockid_t clock) {
    timespec time;
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }
double process_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

Timing time_once(const Job& job, const Peer& peer, int threads, Answers& answers) {
    std::atomic<std::size_t> next{0};
    const auto work = [&](double& cpu) {
        const double start = thread_seconds();
        for (std::size_t batch = next++; batch < job.batches; batch = next++) job.run(peer, batch, answers);
        cpu = thread_seconds() - start;
    };
    std::vector<double> cpu(static_cast<std::size_t>(threads));
    const double start = wall_seconds();
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < cpu.size(); ++i) helpers.emplace_back([&, i] { work(cpu[i]); });
    work(cpu[0]);
    for (std::thread& helper : helpers) helper.join();
    Timing timing{0, wall_seconds() - start};
    for (const double seconds : cpu) timing.cpu += seconds;
    return timing;
}

Timings time_rounds(const Job& job, const std::vector<Peer>& peers, int rounds) {
    Timings timings(peers.size());
    Answers answers = job.room;
    for (const Peer& peer : peers) time_once(job, peer, 1, answers);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t turn = 0; turn < peers.size(); ++turn) {
            const std::size_t peer = round % 2 == 0 ? turn : peers.size() - 1 - turn;
            timings[peer].push_back(time_once(job, peers[peer], 1, answers));
        }
    return timings;
}

Timings time_threads(const Job& job, const Peer& peer, int rounds) {
    Timings timings(2);
    Answers answers = job.room;
    for (int round = 0; round < rounds; ++round)
        for (int turn = 0; turn < 2; ++turn) {
            const int threads = (round + turn) % 2 == 0 ? 1 : 2;
            timings[threads == 1 ? 0 : 1].push_back(time_once(job, peer, threads, answers));
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
