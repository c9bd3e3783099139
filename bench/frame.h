#pragma once
// The set `frame`: pictures traced and shaded in tiles of 64 pixels, as a renderer does.

#include "jobs.h"

namespace glint::bench {

Job frame_job(const Model& model, const tracing::Mesh& reference, const JobOptions& options);

} // namespace glint::bench
