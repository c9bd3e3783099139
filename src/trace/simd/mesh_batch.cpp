// Batch kernels for every SIMD target: groups of up to 64 rays, mostly of one octant, traverse a MeshTree
// together; each stack entry carries a 64-bit mask of the rays that enter the node.
//
// Coherent groups are bounded by a shaft that culls eight children, or the triangles of a leaf, at once
// before any ray is tested (after Reshetov, Soupikov, Hurley 2005 and Boulos, Wald, Benthin 2008). Incoherent
// groups are filtered ray by ray with each node fetched once for all (Barringer and Akenine-Möller, "Dynamic
// Ray Stream Traversal", 2014). The result is the least (t, triangle), so it depends on neither traversal
// order, kernel nor vector width.

#include "trace/mesh/scalar.h"
#include "trace/simd/flags.h"
#include "trace/simd/kernel_table.h"

#include <type_traits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/simd/mesh_batch.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/cache_control.h>

#include "trace/simd/mesh_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::trace {
namespace HWY_NAMESPACE {

TriangleRecord closest_single(const MeshTree& tree, const Ray& ray);
bool occluded_single(const MeshTree& tree, const Ray& ray);

#if HWY_TARGET == HWY_SCALAR

void closest_batch(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                   BatchForm) {
    for (std::size_t i = 0; i < count; ++i) records[i] = closest_scalar(tree, rays[i]);
}
void occluded_batch(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                    BatchForm) {
    for (std::size_t i = 0; i < count; ++i) blocked[i] = occluded_scalar(tree, rays[i]) ? 1 : 0;
}

#else

namespace {

/// A stack entry: a node or leaf and the rays that enter it.
struct Entry {
    std::uint32_t code;
    float key; ///< lower bound of the entry distances; nearer entries are visited first
    std::uint64_t mask;
};

constexpr std::size_t stack_size = wide_children * (max_tree_depth + 1);

HWY_INLINE void prefetch(const MeshTree& tree, std::uint32_t code) {
    const char* const at = (code & leaf_bit) != 0
                               ? reinterpret_cast<const char*>(tree.leaf_words.data() + LeafCode{code}.word())
                               : reinterpret_cast<const char*>(tree.nodes.data() + code);
    for (std::size_t line = 0; line < 256; line += 64) hwy::Prefetch(at + line);
}

/// Pushes the entered children, nearest on top.
HWY_INLINE std::size_t push(const MeshTree& tree, const WideNode& node, const Entered& entered, Entry* stack,
                            std::size_t size) {
    const std::size_t base = size;
    for (std::uint32_t rest = entered.children; rest != 0; rest &= rest - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(rest));
        const Entry entry{node.child[child], entered.key[child], entered.mask[child]};
        prefetch(tree, entry.code);
        std::size_t at = size++;
        for (; at > base && stack[at - 1].key < entry.key; --at) stack[at] = stack[at - 1];
        stack[at] = entry;
    }
    return size;
}

/// Rays of a mask whose current hit is not closer than `key`.
HWY_INLINE std::uint64_t still_active(const Group& group, std::uint64_t mask, float key) {
    std::uint64_t wants = 0;
    for (std::uint64_t rest = vectors_of(mask); rest != 0; rest &= rest - 1) {
        const std::size_t i = first_bit(rest);
        wants |= std::uint64_t{bits_of(dr, hn::Ge(hn::Load(dr, group.limit + i), hn::Set(dr, key)))} << i;
    }
    return wants & mask;
}

/// Groups with fewer rays skip the test of their swept box.
constexpr int min_swept = 16;
/// Cost of testing a vector of rays against one box, in units of testing one ray against eight boxes.
constexpr int vector_cost = ray_lanes > lanes ? 2 : 1;

/// Tests children that the swept box overlaps, one box at a time; returns false if testing ray by ray is
/// cheaper.
template <bool is_mixed>
HWY_INLINE bool enter_swept(const float* node, const Sweep* sweep, const Group& group, std::uint64_t mask,
                            Entered& entered) {
    const int rays = std::popcount(mask);
    if (sweep == nullptr || rays < min_swept) return false;
    const std::uint32_t met = sweep->meets(node);
    const std::uint64_t vectors = vectors_of(mask);
    if (vector_cost * std::popcount(met) * std::popcount(vectors) >= rays) return false;
    enter_boxes<true, is_mixed>(node, met, group, vectors, mask, entered);
    return true;
}

/// Traverses from a node with the rays in `alive`, filtering ray by ray; returns the rays that hit. `sweep`,
/// if not null, culls children for all of them.
template <bool any, bool is_mixed = false>
std::uint64_t trace_stream(const MeshTree& tree, const Sweep* sweep, Group& group, std::uint32_t code,
                           std::uint64_t alive) {
    std::uint64_t hits = 0;
    Entry stack[stack_size];
    std::size_t size = 0;
    stack[size++] = {code, -infinity, alive};
    while (size > 0) {
        const Entry entry = stack[--size];
        const std::uint64_t mask = any ? entry.mask & alive : still_active(group, entry.mask, entry.key);
        if (mask == 0) continue;
        if ((entry.code & leaf_bit) != 0) {
            tally(&TraceCounters::leaves, 1);
            const std::uint64_t found = test_one_by_one<any>(Leaf(tree, LeafCode{entry.code}), group, mask);
            hits |= found;
            if (any) alive &= ~found;
            if (any && alive == 0) break;
            continue;
        }
        tally(&TraceCounters::nodes, 1);
        const WideNode& node = tree.nodes[entry.code];
        Entered entered;
        if (!enter_swept<is_mixed>(&node.lo[0][0], sweep, group, mask, entered))
            enter_by_ray<true, is_mixed>(&node.lo[0][0], group, mask, entered);
        size = push(tree, node, entered, stack, size);
    }
    return hits;
}

/// Traverses with a group of one dominant axis bounded by a shaft; returns the rays that hit.
template <bool any>
std::uint64_t trace_packet(const MeshTree& tree, const TreeConstants& constants, Group& group) {
    const std::size_t axis = group.axis_rays[0] != 0 ? 0u : (group.axis_rays[1] != 0 ? 1u : 2u);
    std::uint64_t alive = group.all();
    std::uint64_t hits = 0;
    Shaft shaft(group, constants, axis);
    bool is_stale = false;
    Entry stack[stack_size];
    std::size_t size = 0;
    stack[size++] = {0, -infinity, alive};
    while (size > 0) {
        const Entry entry = stack[--size];
        const std::uint64_t mask =
            any ? entry.mask & alive : (hits == 0 ? entry.mask : still_active(group, entry.mask, entry.key));
        if (mask == 0) continue;
        // Once all rays have a hit, shorten the shaft to the farthest one.
        if (!any && is_stale && hits == alive) {
            shaft.shorten(group);
            is_stale = false;
        }
        if ((entry.code & leaf_bit) != 0) {
            tally(&TraceCounters::leaves, 1);
            const std::uint64_t found =
                test_in_shaft<any>(Leaf(tree, LeafCode{entry.code}), shaft, group, mask) & alive;
            hits |= found;
            is_stale = is_stale || found != 0;
            if (any) alive &= ~found;
            if (any && alive == 0) break;
            continue;
        }
        tally(&TraceCounters::nodes, 1);
        const float* const node = &tree.nodes[entry.code].lo[0][0];
        Entered entered;
        const std::uint32_t met = shaft.meets(node, group, entered.key);
        if (met == 0) continue;
        // With few active rays in each vector, continue ray by ray.
        const std::uint64_t vectors = vectors_of(mask);
        if (std::popcount(met) * std::popcount(vectors) > std::popcount(mask) + 2) {
            const std::uint64_t found = trace_stream<any>(tree, nullptr, group, entry.code, mask);
            hits |= found;
            is_stale = is_stale || found != 0;
            if (any) alive &= ~found;
            if (any && alive == 0) break;
            continue;
        }
        enter_boxes<!any, false>(node, met, group, vectors, mask, entered);
        size = push(tree, tree.nodes[entry.code], entered, stack, size);
    }
    return hits;
}

/// Writes the records of a group in its order.
void write_records(const Group& group, TriangleRecord* records) {
    const hn::RebindToUnsigned<decltype(df)> du;
    for (std::size_t i = 0; i < group.count; i += lanes) {
        const auto triangle = hn::Load(du, group.triangle + i);
        const auto missed = hn::RebindMask(df, hn::Eq(triangle, hn::Set(du, invalid_index)));
        const Floats t = hn::IfThenElse(missed, hn::Set(df, infinity), hn::Load(df, group.limit + i));
        hn::StoreInterleaved4(t, hn::Load(df, group.u + i), hn::Load(df, group.v + i),
                              hn::BitCast(df, triangle), df, reinterpret_cast<float*>(records + i));
    }
}
static_assert(sizeof(TriangleRecord) == 16);

constexpr std::size_t octants = 8;
constexpr std::size_t class_count = 3 * octants; ///< octant × dominant axis
/// Smaller groups are not traced as packets.
constexpr std::size_t min_packet = 8;
/// Groups of one octant smaller than this are merged with others.
constexpr std::size_t min_stream = 32;

/// Incoherent rays with neighbouring origins share more nodes than rays of one octant from farther apart,
/// unless they pass many surfaces before they hit: measured on scans (depth complexity 0.7 to 1.2) and
/// architecture (3.0). For any-hit rays keeping neighbours together pays only in trees too large for the
/// caches.
constexpr double max_mixed_complexity = 2.0;
constexpr std::size_t large_tree = std::size_t{1} << 25U;

/// Divides a batch into groups and traces them. Tiles of 64 consecutive rays of one class are traced at once,
/// in some trees all tiles are; other rays are queued by class until the queue is full or the batch ends.
template <bool any>
class Batch {
  public:
    using Result = std::conditional_t<any, std::uint8_t, TriangleRecord>;

    Batch(const MeshTree& tree, const Ray* rays, Result* results, BatchForm form)
        : tree_(tree), constants_(tree), rays_(rays), results_(results), by_axis_(form == BatchForm::packets),
          keeps_neighbours_(!by_axis_ && tree.depth_complexity < max_mixed_complexity &&
                            (!any || tree.bytes() >= large_tree)) {}

    void run(std::size_t count) {
        for (std::size_t at = 0; at < count; at += group_rays) tile(at, std::min(group_rays, count - at));
        flush();
    }

  private:
    struct Queue {
        std::uint32_t count = 0;
        std::uint32_t rays[group_rays];
    };

    void tile(std::size_t at, std::size_t count) {
        const Signs signs = load_tile(group_, constants_, rays_ + at, count);
        const std::uint64_t live = count == group_rays ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
        const std::uint64_t ungrouped = signs.ungrouped & live;
        const std::uint64_t grouped = live & ~ungrouped;
        const bool are_alike = grouped != 0 && (grouped & ~signs.alike(first_bit(grouped), by_axis_)) == 0;
        if (std::popcount(ungrouped) < std::popcount(grouped) && (are_alike || keeps_neighbours_)) {
            // Replace each ungrouped ray by a copy of a grouped one, so that a few of them do not break up
            // the tile.
            for (std::uint64_t r = signs.ungrouped; r != 0; r &= r - 1)
                duplicate_ray(group_, first_bit(grouped), first_bit(r));
            trace_tile(at, count, !are_alike);
        } else {
            sort(at, grouped, signs);
        }
        for (std::uint64_t r = ungrouped; r != 0; r &= r - 1) trace_single(at + first_bit(r));
    }

    /// Queues the rays of a tile by class and traces full queues.
    void sort(std::size_t at, std::uint64_t rays, const Signs& signs) {
        for (std::uint64_t rest = rays; rest != 0;) {
            const std::size_t first = first_bit(rest);
            Queue& queue = queues_[signs.octant(first) + (by_axis_ ? octants * signs.dominant(first) : 0)];
            const std::uint64_t same = rest & signs.alike(first, by_axis_);
            rest &= ~same;
            for (std::uint64_t r = same; r != 0; r &= r - 1) {
                queue.rays[queue.count++] = static_cast<std::uint32_t>(at + first_bit(r));
                if (queue.count == group_rays) trace_queue(queue, by_axis_);
            }
        }
    }

    /// Traces all queued rays. Small classes are merged across octants and axes.
    void flush() {
        Queue few;
        std::uint32_t classes = 0;
        for (std::size_t c = 0; c < class_count; ++c) {
            Queue& queue = queues_[c];
            if (queue.count >= (by_axis_ ? min_packet : min_stream)) {
                trace_queue(queue, by_axis_);
                continue;
            }
            for (std::size_t i = 0; i < queue.count; ++i) {
                few.rays[few.count++] = queue.rays[i];
                classes |= 1u << c % octants;
                if (few.count < group_rays) continue;
                trace_queue(few, false, !std::has_single_bit(classes));
                classes = 0;
            }
        }
        trace_queue(few, false, !std::has_single_bit(classes));
    }

    void trace_single(std::size_t i) {
        if constexpr (any) {
            results_[i] = occluded_single(tree_, rays_[i]) ? 1 : 0;
        } else {
            results_[i] = closest_single(tree_, rays_[i]);
        }
    }

    std::uint64_t trace_group(bool is_packet) {
        if (is_packet) return trace_packet<any>(tree_, constants_, group_);
        const Sweep sweep(group_, constants_);
        if (group_.is_mixed) return trace_stream<any, true>(tree_, &sweep, group_, 0, group_.all());
        return trace_stream<any>(tree_, &sweep, group_, 0, group_.all());
    }

    void trace_tile(std::size_t at, std::size_t count, bool is_mixed) {
        set_up(group_, constants_, is_mixed);
        const std::uint64_t hits = trace_group(by_axis_ && count >= min_packet);
        if constexpr (any) {
            write_flags(hits, results_ + at, count);
        } else if (count == group_rays) {
            write_records(group_, results_ + at);
        } else {
            TriangleRecord found[group_rays];
            write_records(group_, found);
            std::copy_n(found, count, results_ + at);
        }
    }

    void trace_queue(Queue& queue, bool is_packet, bool is_mixed = false) {
        if (queue.count == 0) return;
        load_numbered(group_, rays_, queue.rays, queue.count);
        set_up(group_, constants_, is_mixed);
        const std::uint64_t hits = trace_group(is_packet);
        if constexpr (any) {
            for (std::size_t i = 0; i < queue.count; ++i) results_[queue.rays[i]] = hits >> i & 1u;
        } else {
            TriangleRecord found[group_rays];
            write_records(group_, found);
            for (std::size_t i = 0; i < queue.count; ++i) results_[queue.rays[i]] = found[i];
        }
        queue.count = 0;
    }

    const MeshTree& tree_;
    const TreeConstants constants_;
    const Ray* rays_;
    Result* results_;
    bool by_axis_;
    bool keeps_neighbours_; ///< trace tiles of several octants as they are
    Queue queues_[class_count];
    Group group_;
};

} // namespace

// Exported to the kernel table.
void closest_batch(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                   BatchForm form) {
    if (tree.nodes.empty()) {
        std::fill_n(records, count, TriangleRecord{});
    } else {
        Batch<false>(tree, rays, records, form).run(count);
    }
}
void occluded_batch(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                    BatchForm form) {
    if (tree.nodes.empty()) {
        std::fill_n(blocked, count, std::uint8_t{0});
    } else {
        Batch<true>(tree, rays, blocked, form).run(count);
    }
}

#endif

extern const BatchKernels batch{closest_batch, occluded_batch};

} // namespace HWY_NAMESPACE
} // namespace glint::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint::trace {

const KernelTable<BatchKernels> batch_kernels GLINT_KERNEL_TABLE(batch);

} // namespace glint::trace
#endif
