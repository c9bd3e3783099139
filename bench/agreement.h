#pragma once
// Comparing the results of peers.

#include "jobs.h"

#include <cstdint>

namespace glint::bench {

/// Results of one peer for a whole job.
Answers answers_of(const Job& job, const Peer& peer);

/// Number of results that are not bitwise equal.
std::uint64_t different_bits(const Answers& a, const Answers& b);

/// Number of results that differ by more than rounding: hit against miss, blocked against free, t by more
/// than a factor of 1 ± 10⁻⁴, or a pixel by more than 1/255. Different triangles at the same t count as
/// equal.
std::uint64_t different_answers(const Answers& a, const Answers& b);

} // namespace glint::bench
