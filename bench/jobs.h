#pragma once
// What is timed: five sets of rays, each the same for every peer.

#include "model.h"
#include "peer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace glint::bench {

/// What a peer answers.
struct Answers {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> blocked;
    std::vector<float> image; ///< of the set `frame`: one value a pixel
};

/// Batches that may be asked for in any order, on any thread, each writing its own part of the answers.
struct Job {
    std::string name;
    std::uint64_t rays = 0;
    std::size_t batches = 0;
    Answers room; ///< empty answers of the right sizes
    std::function<void(const Peer& peer, std::size_t batch, Answers& answers)> run;
};

struct JobOptions {
    int size = 1024;          ///< pixels a side, a multiple of 8
    std::size_t batch = 4096; ///< rays a call, but for `frame`: 64
};

inline constexpr const char* job_names[] = {"primary", "shadow", "ao", "bounce", "frame"};

/// Rays found with `reference`, one at a time. `model` must outlive the job.
Job make_job(const std::string& name, const Model& model, const tracing::Mesh& reference,
             const JobOptions& options);

} // namespace glint::bench
