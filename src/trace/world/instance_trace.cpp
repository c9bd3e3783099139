// Tracing an InstanceTree with single rays and batches. A batch descends as lists of rays filtered at each
// box (Barringer and Akenine-Möller, "Dynamic Ray Stream Traversal", 2014), so an instance gets all rays that
// meet its box at once.

#include "math/offset.shared.h"
#include "trace/mesh/scalar.h"
#include "trace/world/instance_tree.h"

#include <type_traits>

namespace glint::trace {
namespace {

constexpr std::size_t batch_rays = 4096;
/// Fewer rays at a node are traced one by one.
constexpr std::size_t min_batch = 8;
/// Incoherent rays spread over all instances: with fewer rays for each, lists do not pay.
constexpr std::size_t min_rays_per_instance = 16;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The ray with tmax such that `limit` is included.
Ray limited(Ray ray, float limit) {
    ray.tmax = next_float(limit, 1.0f);
    return ray;
}

/// Keeps the lesser of two hits.
void keep(const TriangleRecord& found, std::uint32_t instance, InstanceRecord& best, float& limit) {
    if (found.triangle == invalid_index) return;
    if (found.t == best.t && instance > best.instance) return;
    best = {found.t, found.u, found.v, found.triangle, instance};
    limit = found.t;
}

/// A queued ray, and where it enters the node's box.
struct Active {
    std::uint32_t ray;
    float entry;
};

} // namespace

struct InstanceTree::Batch {
    std::span<const Ray> rays;
    RayHint hint = RayHint::coherent;
    KernelChoice choice;
    InstanceRecord* records = nullptr; ///< output of closest(), null otherwise
    std::uint8_t* blocked = nullptr;   ///< output of occluded(), null otherwise
    std::vector<Query> queries;        ///< by ray, including rays that cannot hit anything
    std::vector<float> limits;         ///< by ray: upper bound of t, inclusive

    /// A node and its rays: a range of `waiting`.
    struct Pending {
        TreeRef ref;
        std::size_t first;
    };
    std::vector<Pending> stack; ///< ranges are adjacent, that of the top entry last
    std::vector<Active> waiting;
    std::vector<Active> active; ///< rays at the current node
    std::vector<float> entries; ///< two for each ray in `active`

    std::vector<Ray> local_rays;
    std::vector<TriangleRecord> local_records;
    std::vector<std::uint8_t> local_blocked;

    Batch(std::span<const Ray> all, RayHint ray_hint, const KernelChoice& kernel, const InstanceTree& tree)
        : rays(all), hint(ray_hint), choice(kernel) {
        queries.reserve(rays.size());
        limits.reserve(rays.size());
        for (std::uint32_t i = 0; i < rays.size(); ++i) {
            queries.emplace_back(rays[i], tree.tree_.bounds);
            limits.push_back(limit_below(rays[i].tmax));
            if (is_traceable(rays[i])) waiting.push_back({i, rays[i].tmin});
        }
        stack.push_back({tree.tree_.root, 0});
    }

    /// Pops the top of the stack and drops rays that have found a closer hit since.
    TreeRef pop() {
        const Pending top = stack.back();
        stack.pop_back();
        active.clear();
        for (std::size_t i = top.first; i < waiting.size(); ++i)
            if (waiting[i].entry <= limits[waiting[i].ray]) active.push_back(waiting[i]);
        waiting.resize(top.first);
        return top.ref;
    }

    void block(std::uint32_t ray) {
        blocked[ray] = 1;
        limits[ray] = -infinity;
    }

    void push(const TreeRef& ref, std::size_t child) {
        const std::size_t first = waiting.size();
        for (std::size_t i = 0; i < active.size(); ++i)
            if (entries[2 * i + child] < infinity) waiting.push_back({active[i].ray, entries[2 * i + child]});
        if (waiting.size() > first) stack.push_back({ref, first});
    }
};

/// Traces all active rays through one instance.
template <bool any>
void InstanceTree::trace_instance(std::uint32_t instance, Batch& batch) const {
    const MeshTree& mesh = *instances_[instance].mesh;
    batch.local_rays.clear();
    for (const Active& at : batch.active)
        batch.local_rays.push_back(to_local(instance, limited(batch.rays[at.ray], batch.limits[at.ray])));
    const std::size_t count = batch.active.size();
    if constexpr (any) {
        batch.local_blocked.resize(count);
        trace::occluded(mesh, batch.local_rays, batch.local_blocked, batch.hint, batch.choice);
        for (std::size_t i = 0; i < count; ++i)
            if (batch.local_blocked[i] != 0) batch.block(batch.active[i].ray);
    } else {
        batch.local_records.resize(count);
        trace::closest(mesh, batch.local_rays, batch.local_records, batch.hint, batch.choice);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t ray = batch.active[i].ray;
            keep(batch.local_records[i], instance, batch.records[ray], batch.limits[ray]);
        }
    }
}

/// Traces each active ray by itself through the subtree of a node.
template <bool any>
void InstanceTree::trace_each(TreeRef from, Batch& batch) const {
    for (const Active& at : batch.active) {
        float& limit = batch.limits[at.ray];
        visit_below(from, batch.queries[at.ray], limit, [&](std::uint32_t instance) {
            const Ray local = to_local(instance, limited(batch.rays[at.ray], limit));
            if constexpr (any) {
                const bool found = trace::occluded(mesh(instance), local, batch.choice);
                if (found) batch.block(at.ray);
                return found;
            } else {
                keep(trace::closest(mesh(instance), local, batch.choice), instance, batch.records[at.ray],
                     limit);
                return false;
            }
        });
    }
}

template <bool any>
void InstanceTree::trace(Batch& batch) const {
    const bool spread =
        batch.hint == RayHint::incoherent && batch.rays.size() < min_rays_per_instance * instances_.size();
    const std::size_t few = spread ? batch_rays + 1 : min_batch;
    while (!batch.stack.empty()) {
        const TreeRef at = batch.pop();
        if (batch.active.size() < few) {
            trace_each<any>(at, batch);
            continue;
        }
        if (at.count > 0) {
            trace_instance<any>(tree_.order[at.first], batch);
            continue;
        }
        batch.entries.clear();
        std::size_t second_nearer = 0;
        for (const Active& active : batch.active) {
            const Query& query = batch.queries[active.ray];
            const float limit = batch.limits[active.ray];
            const float first = entry(query, at.first, 0, limit);
            const float second = entry(query, at.first, 1, limit);
            batch.entries.push_back(first);
            batch.entries.push_back(second);
            second_nearer += second < first ? 1u : 0u;
        }
        // Push the child that is nearer for most rays last.
        const std::size_t near = 2 * second_nearer > batch.active.size() ? 1 : 0;
        const TreeNode& node = tree_.nodes[at.first];
        batch.push(node.child[1 - near], 1 - near);
        batch.push(node.child[near], near);
    }
}

InstanceRecord InstanceTree::closest(const Ray& ray, const KernelChoice& choice) const {
    InstanceRecord best;
    float limit = limit_below(ray.tmax);
    if (!is_traceable(ray)) return best;
    visit(ray, limit, [&](std::uint32_t instance) {
        keep(trace::closest(mesh(instance), to_local(instance, limited(ray, limit)), choice), instance, best,
             limit);
        return false;
    });
    return best;
}

bool InstanceTree::occluded(const Ray& ray, const KernelChoice& choice) const {
    if (!is_traceable(ray)) return false;
    bool found = false;
    const float limit = limit_below(ray.tmax);
    visit(ray, limit, [&](std::uint32_t instance) {
        return found = trace::occluded(mesh(instance), to_local(instance, ray), choice);
    });
    return found;
}

template <class Result>
void InstanceTree::trace_batches(std::span<const Ray> rays, std::span<Result> results, RayHint hint,
                                 const KernelChoice& choice) const {
    constexpr bool any = std::is_same_v<Result, std::uint8_t>;
    for (std::size_t at = 0; at < rays.size(); at += batch_rays) {
        const std::size_t count = std::min(batch_rays, rays.size() - at);
        std::fill_n(results.data() + at, count, Result{});
        if (tree_.empty()) continue;
        Batch batch(rays.subspan(at, count), hint, choice, *this);
        if constexpr (any)
            batch.blocked = results.data() + at;
        else
            batch.records = results.data() + at;
        trace<any>(batch);
    }
}

void InstanceTree::closest(std::span<const Ray> rays, std::span<InstanceRecord> records, RayHint hint,
                           const KernelChoice& choice) const {
    trace_batches(rays, records, hint, choice);
}

void InstanceTree::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, RayHint hint,
                            const KernelChoice& choice) const {
    trace_batches(rays, blocked, hint, choice);
}

} // namespace glint::trace
