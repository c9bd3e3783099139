#pragma once
// The set `frame`: pictures in tiles of 64 pixels, traced and shaded as a renderer would.

#include "jobs.h"

namespace glint::bench {

Job frame_job(const Model& model, const tracing::Mesh& reference, const JobOptions& options);

} // namespace glint::bench
