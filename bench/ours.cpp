#include "peer.h"

namespace glint::bench {
namespace {

RayHint other(RayHint hint) { return hint == RayHint::coherent ? RayHint::incoherent : RayHint::coherent; }

} // namespace

tracing::Mesh build_ours(const Model& model, int threads) {
    const Mesh& mesh = *model.mesh;
    return {tracing::Vertices(&mesh.positions.data()->x, mesh.positions.size(), sizeof(vec3)),
            tracing::Triangles(&mesh.triangles.data()->x, mesh.triangles.size(), sizeof(uvec3)),
            {.threads = threads}};
}

Peer our_peer(const tracing::Mesh& mesh) {
    return {"glint", Group::ours,
            [mesh](std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) {
                mesh.closest(rays, hits, hint);
            },
            [mesh](std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint) {
                mesh.occluded(rays, blocked, hint);
            }};
}

std::vector<Peer> our_other_ways(const tracing::Mesh& mesh) {
    return {{"glint, the other hint", Group::ours,
             [mesh](std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) {
                 mesh.closest(rays, hits, other(hint));
             },
             [mesh](std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint) {
                 mesh.occluded(rays, blocked, other(hint));
             }},
            {"glint, ray by ray", Group::ours,
             [mesh](std::span<const Ray> rays, std::span<Hit> hits, RayHint) {
                 for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = mesh.closest(rays[i]);
             },
             [mesh](std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint) {
                 for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = mesh.occluded(rays[i]) ? 1 : 0;
             }}};
}

} // namespace glint::bench
