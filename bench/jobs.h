#pragma once
// The sets of rays to measure, identical for all peers.

#include "model.h"
#include "peer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace glint::bench {

/// Results of a peer.
struct Answers {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> blocked;
    std::vector<float> image; ///< for `frame`: one value a pixel
};

/// Batches that can be traced in any order on any thread, each writing its own part of the results.
struct Job {
    std::string name;
    std::uint64_t rays = 0;
    std::size_t batches = 0;
    Answers empty_answers; ///< empty results of the right sizes
    std::function<void(const Peer& peer, std::size_t batch, Answers& answers)> run;
};

struct JobOptions {
    int size = 1024;          ///< pixels a side, a multiple of 8
    std::size_t batch = 4096; ///< rays a call (`frame` uses 64)
};

inline constexpr const char* job_names[] = {"primary", "shadow", "ao", "bounce", "frame"};

/// Makes a job; secondary rays are computed with `reference`, one at a time. `model` must outlive the job.
Job make_job(const std::string& name, const Model& model, const tracing::Mesh& reference,
             const JobOptions& options);

/// The job `frame`: pictures traced and shaded in tiles of 64 pixels, as a renderer does.
Job frame_job(const Model& model, const tracing::Mesh& reference, const JobOptions& options);

} // namespace glint::bench
