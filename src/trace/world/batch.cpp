// Batch queries of World: first planes and quadrics, then meshes and instances for the rays that may still
// hit one.

#include "trace/simd/quadric_batch.h"
#include "trace/world/world.h"

#include <algorithm>
#include <cstring>

namespace glint::trace {

namespace {

bool has_no_triangles(const WorldData& world) {
    return world.mesh_tree.nodes.empty() && world.instances.empty();
}

/// Grows a vector without shrinking or clearing it.
template <class T>
T* grown(std::vector<T>& v, std::size_t count) {
    if (v.size() < count) v.resize(count);
    return v.data();
}

/// Calls use(i) for every flag that is set, skipping eight clear flags at once.
template <class Use>
void for_each_set(std::span<const std::uint8_t> flags, Use&& use) {
    for (std::size_t i = 0; i < flags.size(); i += 8) {
        std::uint64_t eight = 0;
        const std::size_t count = std::min<std::size_t>(8, flags.size() - i);
        std::memcpy(&eight, &flags[i], count);
        if (eight == 0) continue;
        for (std::size_t k = i; k < i + count; ++k)
            if (flags[k] != 0) use(static_cast<std::uint32_t>(k));
    }
}

} // namespace

void World::closest(std::span<const Ray> rays, std::span<Hit> hits, RayHint hint, Scratch& scratch,
                    const KernelChoice& choice) const {
    const std::size_t count = rays.size();
    std::uint8_t* meets_mesh = grown(scratch.flags, count);
    quadric_kernels[row_of(choice.target)]->closest(*data_, rays.data(), count, hits.data(), meets_mesh);
    if (!data_->wide_tree.nodes.empty())
        for (std::size_t i = 0; i < count; ++i) keep_closer_wide(*data_, rays[i], hits[i]);
    if (has_no_triangles(*data_)) return;

    Ray* rest = grown(scratch.rays, count);
    std::uint32_t* indices = grown(scratch.numbers, count);
    std::size_t count_left = 0;
    for_each_set({meets_mesh, count}, [&](std::uint32_t i) {
        rest[count_left] = rays[i];
        if (hits[i]) rest[count_left].tmax = next_float(hits[i].t, 1.0f);
        indices[count_left++] = i;
    });
    if (!data_->mesh_tree.nodes.empty()) {
        TriangleRecord* records = grown(scratch.records, count_left);
        trace::closest(data_->mesh_tree, {rest, count_left}, {records, count_left}, hint, choice);
        for (std::size_t i = 0; i < count_left; ++i) {
            if (records[i].triangle == invalid_index) continue;
            keep_closer(*data_, rays[indices[i]], records[i], hits[indices[i]]);
            rest[i].tmax = next_float(hits[indices[i]].t, 1.0f);
        }
    }
    if (data_->instances.empty()) return;
    InstanceRecord* records = grown(scratch.instance_records, count_left);
    data_->instance_tree.closest({rest, count_left}, {records, count_left}, hint, choice);
    for (std::size_t i = 0; i < count_left; ++i)
        if (records[i].instance != invalid_index)
            keep_closer(*data_, rays[indices[i]], records[i], hits[indices[i]]);
}

void World::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                     Scratch& scratch, const KernelChoice& choice) const {
    const std::size_t count = rays.size();
    std::uint8_t* meets_mesh = grown(scratch.flags, count);
    quadric_kernels[row_of(choice.target)]->occluded(*data_, rays.data(), count, blocked.data(), meets_mesh);
    if (!data_->wide_tree.nodes.empty())
        for (std::size_t i = 0; i < count; ++i) {
            if (blocked[i] != 0 || !occluded_by_wide(*data_, rays[i])) continue;
            blocked[i] = 1;
            meets_mesh[i] = 0;
        }
    if (has_no_triangles(*data_)) return;

    Ray* rest = grown(scratch.rays, count);
    std::uint32_t* indices = grown(scratch.numbers, count);
    std::size_t count_left = 0;
    for_each_set({meets_mesh, count}, [&](std::uint32_t i) {
        rest[count_left] = rays[i];
        indices[count_left++] = i;
    });
    // The flags have been read, so their memory can hold results.
    std::uint8_t* results = meets_mesh;
    if (!data_->mesh_tree.nodes.empty()) {
        trace::occluded(data_->mesh_tree, {rest, count_left}, {results, count_left}, hint, choice);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_left; ++i) {
            blocked[indices[i]] = results[i];
            rest[kept] = rest[i];
            indices[kept] = indices[i];
            kept += results[i] ^ 1u;
        }
        count_left = kept;
    }
    if (data_->instances.empty()) return;
    data_->instance_tree.occluded({rest, count_left}, {results, count_left}, hint, choice);
    for (std::size_t i = 0; i < count_left; ++i) blocked[indices[i]] = results[i];
}

void World::surfaces(std::span<const Ray> rays, std::span<const Hit> hits, const SurfaceRows& rows,
                     std::span<std::uint8_t> done, const KernelChoice& choice) const {
    point_kernels[row_of(choice.target)](*data_, rays.data(), hits.data(), rays.size(), rows, done.data());
}

} // namespace glint::trace
