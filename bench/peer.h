#pragma once
// A tracer to measure: its name and functions that trace batches of plain rays.

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
    ours,   ///< glint through its public interface
    embree, ///< Embree with high build quality
    robust  ///< the same with the robust flag: the fair comparison for a watertight tracer
};

struct Peer {
    std::string name;
    Group group = Group::ours;
    std::function<void(std::span<const Ray>, std::span<Hit>, RayHint)> closest;
    std::function<void(std::span<const Ray>, std::span<std::uint8_t>, RayHint)> occluded;
};

tracing::Mesh build_ours(const Model& model, tracing::BuildQuality quality, int threads);

Peer our_peer(const tracing::Mesh& mesh, tracing::SimdTarget target = tracing::SimdTarget::best);

/// glint's other kernels, available SIMD targets and the other build quality: compared bit by bit, not
/// measured.
std::vector<Peer> our_other_variants(const Model& model, const tracing::Mesh& mesh);

/// Embree with single rays, packets of eight and streams; empty without Embree. `isa` is the maximum
/// instruction set, empty for no limit. `model` must outlive the peers.
std::vector<Peer> embree_peers(const Model& model, Group group, const std::string& isa);

/// Version such as "Embree 3.13.5"; empty without Embree.
std::string embree_version();

} // namespace glint::bench
