// glint as a peer.

#include "peer.h"

namespace glint::bench {
namespace {

Peer variant(const std::string& name, const tracing::Mesh& mesh, const tracing::KernelChoice& choice) {
    return {name, Group::ours,
            [=](std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) {
                mesh.closest(rays, hits, hint, choice);
            },
            [=](std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint) {
                mesh.occluded(rays, blocked, hint, choice);
            }};
}

} // namespace

tracing::Mesh build_ours(const Model& model, tracing::BuildQuality quality, int threads) {
    const Mesh& mesh = *model.mesh;
    return {tracing::Vertices(&mesh.positions.data()->x, mesh.positions.size(), sizeof(vec3)),
            tracing::Triangles(&mesh.triangles.data()->x, mesh.triangles.size(), sizeof(uvec3)),
            {quality, threads}};
}

Peer our_peer(const tracing::Mesh& mesh, tracing::SimdTarget target) {
    return variant("glint", mesh, {tracing::Kernel::automatic, target});
}

std::vector<Peer> our_other_variants(const Model& model, const tracing::Mesh& mesh) {
    using tracing::Kernel;
    using tracing::SimdTarget;
    std::vector<Peer> variants;
    variants.push_back(variant("glint, scalar", mesh, {Kernel::scalar, SimdTarget::best}));
    for (const SimdTarget target :
         {SimdTarget::plain, SimdTarget::sse4, SimdTarget::avx2, SimdTarget::avx512}) {
        if (!is_available(target)) continue;
        variants.push_back(variant("glint, single", mesh, {Kernel::single, target}));
        variants.push_back(variant("glint, packets", mesh, {Kernel::packets, target}));
        variants.push_back(variant("glint, streams", mesh, {Kernel::streams, target}));
    }
    variants.push_back(variant("glint, fast", build_ours(model, tracing::BuildQuality::fast, 1), {}));
    return variants;
}

} // namespace glint::bench
