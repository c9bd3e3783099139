#pragma once
// Who is measured: a name and what it does with batches of plain rays.

#include "glint/trace.h"
#include "model.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace glint::bench {

using tracing::Hit;
using tracing::Ray;
using tracing::RayHint;

enum class Group {
    ours,   ///< what a caller of the public interface gets
    embree, ///< Embree with its high quality
    robust  ///< the same, with the flag for a robust scene: the fair peer of a watertight tracer
};

struct Peer {
    std::string name;
    Group group = Group::ours;
    std::function<void(std::span<const Ray>, std::span<Hit>, RayHint)> closest;
    std::function<void(std::span<const Ray>, std::span<std::uint8_t>, RayHint)> occluded;
};

tracing::Mesh build_ours(const Model& model, tracing::BuildQuality quality, int threads);

Peer our_peer(const tracing::Mesh& mesh, tracing::SimdTarget target = tracing::SimdTarget::best);

/// The other ways to the same answers, to be compared bit by bit and not measured: each kernel, each SIMD
/// target that the machine has, and a tree of the other quality.
std::vector<Peer> our_other_ways(const Model& model, const tracing::Mesh& mesh);

/// Single rays, packets of eight and streams; none where the program was built without Embree. `isa` is the
/// most that Embree may use, empty for all. `model` must outlive them.
std::vector<Peer> embree_peers(const Model& model, Group group, const std::string& isa);

/// "Embree 3.13.5", or empty.
std::string embree_version();

} // namespace glint::bench
