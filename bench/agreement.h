#pragma once
// Whether peers say the same.

#include "jobs.h"

#include <cstdint>

namespace glint::bench {

/// What one peer answers to the whole job.
Answers answers_of(const Job& job, const Peer& peer);

/// Answers with a bit that differs.
std::uint64_t different_bits(const Answers& a, const Answers& b);

/// Answers that differ by more than rounding: hit or not, blocked or not, t beyond 10⁻⁴ of it, a pixel beyond
/// 1/255. Which of two triangles at one t was met does not count.
std::uint64_t different_answers(const Answers& a, const Answers& b);

} // namespace glint::bench
