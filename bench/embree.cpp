// Embree 3 as a peer, including the conversion of rays and hits to its layouts.

#include "embree_scene.h"
#include "peer.h"

#include <algorithm>

namespace glint::bench {
namespace {

constexpr unsigned no_geometry = RTC_INVALID_GEOMETRY_ID;

RTCIntersectContext context_for(RayHint hint) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = hint == RayHint::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                              : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

RTCRay to_embree(const Ray& ray) {
    return {ray.origin[0],
            ray.origin[1],
            ray.origin[2],
            ray.tmin,
            ray.direction[0],
            ray.direction[1],
            ray.direction[2],
            0.0f,
            ray.tmax,
            0xffffffffu,
            0,
            0};
}

Hit from_embree(const RTCRayHit& result) {
    if (result.hit.geomID == no_geometry) return {};
    return {result.ray.tfar, result.hit.u, result.hit.v, result.hit.primID};
}

// ── One ray at a time ──

void single_closest(RTCScene scene, std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) {
    RTCIntersectContext context = context_for(hint);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRayHit query;
        query.ray = to_embree(rays[i]);
        query.hit.geomID = no_geometry;
        rtcIntersect1(scene, &context, &query);
        hits[i] = from_embree(query);
    }
}

void single_occluded(RTCScene scene, std::span<const Ray> rays, std::span<std::uint8_t> blocked,
                     RayHint hint) {
    RTCIntersectContext context = context_for(hint);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRay ray = to_embree(rays[i]);
        rtcOccluded1(scene, &context, &ray);
        blocked[i] = ray.tfar < 0 ? 1 : 0;
    }
}

// ── Eight at a time ──

void fill(RTCRay8& packet, std::span<const Ray> rays, int* valid) {
    for (std::size_t k = 0; k < 8; ++k) {
        valid[k] = k < rays.size() ? -1 : 0;
        const Ray& ray = rays[std::min(k, rays.size() - 1)];
        packet.org_x[k] = ray.origin[0];
        packet.org_y[k] = ray.origin[1];
        packet.org_z[k] = ray.origin[2];
        packet.tnear[k] = ray.tmin;
        packet.dir_x[k] = ray.direction[0];
        packet.dir_y[k] = ray.direction[1];
        packet.dir_z[k] = ray.direction[2];
        packet.time[k] = 0;
        packet.tfar[k] = ray.tmax;
        packet.mask[k] = 0xffffffffu;
        packet.id[k] = 0;
        packet.flags[k] = 0;
    }
}

std::size_t packet_end(std::size_t first, std::size_t count) {
    return std::min<std::size_t>(8, count - first);
}

void packet_closest(RTCScene scene, std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) {
    RTCIntersectContext context = context_for(hint);
    for (std::size_t i = 0; i < rays.size(); i += 8) {
        const std::size_t count = packet_end(i, rays.size());
        RTCRayHit8 query;
        alignas(32) int valid[8];
        fill(query.ray, rays.subspan(i, count), valid);
        std::fill_n(query.hit.geomID, 8, no_geometry);
        rtcIntersect8(valid, scene, &context, &query);
        for (std::size_t k = 0; k < count; ++k)
            hits[i + k] = query.hit.geomID[k] == no_geometry
                              ? Hit{}
                              : Hit{query.ray.tfar[k], query.hit.u[k], query.hit.v[k], query.hit.primID[k]};
    }
}

void packet_occluded(RTCScene scene, std::span<const Ray> rays, std::span<std::uint8_t> blocked,
                     RayHint hint) {
    RTCIntersectContext context = context_for(hint);
    for (std::size_t i = 0; i < rays.size(); i += 8) {
        const std::size_t count = packet_end(i, rays.size());
        RTCRay8 packet;
        alignas(32) int valid[8];
        fill(packet, rays.subspan(i, count), valid);
        rtcOccluded8(valid, scene, &context, &packet);
        for (std::size_t k = 0; k < count; ++k) blocked[i + k] = packet.tfar[k] < 0 ? 1 : 0;
    }
}

// ── Streams ──

void stream_closest(RTCScene scene, std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) {
    thread_local std::vector<RTCRayHit> stream;
    if (stream.size() < rays.size()) stream.resize(rays.size());
    RTCIntersectContext context = context_for(hint);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        stream[i].ray = to_embree(rays[i]);
        stream[i].hit.geomID = no_geometry;
    }
    rtcIntersect1M(scene, &context, stream.data(), static_cast<unsigned>(rays.size()), sizeof(RTCRayHit));
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = from_embree(stream[i]);
}

void stream_occluded(RTCScene scene, std::span<const Ray> rays, std::span<std::uint8_t> blocked,
                     RayHint hint) {
    thread_local std::vector<RTCRay> stream;
    if (stream.size() < rays.size()) stream.resize(rays.size());
    RTCIntersectContext context = context_for(hint);
    for (std::size_t i = 0; i < rays.size(); ++i) stream[i] = to_embree(rays[i]);
    rtcOccluded1M(scene, &context, stream.data(), static_cast<unsigned>(rays.size()), sizeof(RTCRay));
    for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = stream[i].tfar < 0 ? 1 : 0;
}

template <class Closest, class Occluded>
Peer peer(const std::string& name, Group group, std::shared_ptr<const EmbreeScene> scene, Closest closest,
          Occluded occluded) {
    return {name, group,
            [=](std::span<const Ray> rays, std::span<Hit> hits, RayHint hint) {
                closest(scene->handle(), rays, hits, hint);
            },
            [=](std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint) {
                occluded(scene->handle(), rays, blocked, hint);
            }};
}

} // namespace

std::vector<Peer> embree_peers(const Model& model, Group group, const std::string& isa) {
    const auto scene =
        std::make_shared<const EmbreeScene>(*model.mesh, EmbreeOptions{true, group == Group::robust, isa});
    const std::string name = group == Group::robust ? "Embree robust" : "Embree";
    return {peer(name + " single", group, scene, single_closest, single_occluded),
            peer(name + " packet8", group, scene, packet_closest, packet_occluded),
            peer(name + " stream", group, scene, stream_closest, stream_occluded)};
}

std::string embree_version() { return "Embree " RTC_VERSION_STRING; }

} // namespace glint::bench
