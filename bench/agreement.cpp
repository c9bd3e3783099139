// Running a peer over all batches, and counting differences.

#include "agreement.h"

#include <bit>
#include <cmath>

namespace glint::bench {
namespace {

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool same_bits(const Hit& a, const Hit& b) {
    return same_bits(a.t, b.t) && same_bits(a.u, b.u) && same_bits(a.v, b.v) && a.triangle == b.triangle;
}

bool close(const Hit& a, const Hit& b) {
    return bool(a) == bool(b) && (!a || std::abs(a.t - b.t) <= 1e-4f * std::abs(a.t));
}

} // namespace

Answers answers_of(const Job& job, const Peer& peer) {
    Answers answers = job.empty_answers;
    for (std::size_t batch = 0; batch < job.batches; ++batch) job.run(peer, batch, answers);
    return answers;
}

std::uint64_t different_bits(const Answers& a, const Answers& b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.hits.size(); ++i) count += same_bits(a.hits[i], b.hits[i]) ? 0u : 1u;
    for (std::size_t i = 0; i < a.blocked.size(); ++i) count += a.blocked[i] == b.blocked[i] ? 0u : 1u;
    for (std::size_t i = 0; i < a.image.size(); ++i) count += same_bits(a.image[i], b.image[i]) ? 0u : 1u;
    return count;
}

std::uint64_t different_answers(const Answers& a, const Answers& b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.hits.size(); ++i) count += close(a.hits[i], b.hits[i]) ? 0u : 1u;
    for (std::size_t i = 0; i < a.blocked.size(); ++i) count += a.blocked[i] == b.blocked[i] ? 0u : 1u;
    for (std::size_t i = 0; i < a.image.size(); ++i)
        count += std::abs(a.image[i] - b.image[i]) <= 1.0f / 255.0f ? 0u : 1u;
    return count;
}

} // namespace glint::bench
