// Batches of rays through a MeshTree, for every SIMD target: groups of up to 64 rays, mostly of one octant,
// go down together, a 64-bit mask for each node telling which of them are there.
//
// Coherent groups are bounded by a shaft that culls eight children, or the triangles of a leaf, at once
// before any ray is looked at (after Reshetov, Soupikov, Hurley 2005 and Boulos, Wald, Benthin 2008);
// incoherent ones are filtered ray by ray, each node fetched once for all (Barringer and Akenine-Möller,
// "Dynamic Ray Stream Traversal", 2014). The answer is the least (t, triangle), so neither order nor kernel
// nor vector width shows in it.

#include "trace/flags.h"
#include "trace/kernel_table.h"

#include <type_traits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/mesh_batch.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/cache_control.h>

#include "trace/mesh_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

TriangleRecord closest_lone(const MeshTree& tree, const Ray& ray);
bool occluded_lone(const MeshTree& tree, const Ray& ray);

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

/// What is still to be visited.
struct Entry {
    std::uint32_t code;
    float key; ///< where the rays may enter it: the nearer goes first
    std::uint64_t mask;
};

constexpr std::size_t stack_size = wide_children * (max_tree_depth + 1);

HWY_INLINE void prefetch(const MeshTree& tree, std::uint32_t code) {
    const char* const at = (code & leaf_bit) != 0
                               ? reinterpret_cast<const char*>(tree.leaf_words.data() + LeafCode{code}.word())
                               : reinterpret_cast<const char*>(tree.nodes.data() + code);
    for (std::size_t line = 0; line < 256; line += 64) hwy::Prefetch(at + line);
}

/// Puts the children that rays enter on the stack, the nearest on top.
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

/// Those rays of a mask that still want what begins at `key`.
HWY_INLINE std::uint64_t wanting(const Group& group, std::uint64_t mask, float key) {
    std::uint64_t wants = 0;
    for (std::uint64_t rest = vectors_of(mask); rest != 0; rest &= rest - 1) {
        const std::size_t i = first_bit(rest);
        wants |= std::uint64_t{bits_of(dr, hn::Ge(hn::Load(dr, group.limit + i), hn::Set(dr, key)))} << i;
    }
    return wants & mask;
}

/// Fewer rays than this are not worth a look at the box that they sweep.
constexpr int least_swept = 16;
/// What a vector of rays against one box costs, in rays against eight boxes.
constexpr int vector_price = ray_lanes > lanes ? 2 : 1;

/// The rays that enter each child which the sweep meets, box by box; false where ray by ray is cheaper.
template <bool is_mixed>
HWY_INLINE bool enter_swept(const float* node, const Sweep* sweep, const Group& group, std::uint64_t mask,
                            Entered& entered) {
    const int rays = std::popcount(mask);
    if (sweep == nullptr || rays < least_swept) return false;
    const std::uint32_t met = sweep->meets(node);
    const std::uint64_t vectors = vectors_of(mask);
    if (vector_price * std::popcount(met) * std::popcount(vectors) >= rays) return false;
    enter_boxes<true, is_mixed>(node, met, group, vectors, mask, entered);
    return true;
}

/// Those rays of a group that `alive` names, ray by ray from a node on; returns the rays that hit.
/// `sweep` culls children for all of them; it may be missing.
template <bool any, bool is_mixed = false>
std::uint64_t trace_stream(const MeshTree& tree, const Sweep* sweep, Group& group, std::uint32_t code,
                           std::uint64_t alive) {
    std::uint64_t hits = 0;
    Entry stack[stack_size];
    std::size_t size = 0;
    stack[size++] = {code, -infinity, alive};
    while (size > 0) {
        const Entry entry = stack[--size];
        const std::uint64_t mask = any ? entry.mask & alive : wanting(group, entry.mask, entry.key);
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

/// A group of one dominant axis within its shaft; returns the rays that hit.
template <bool any>
std::uint64_t trace_packet(const MeshTree& tree, const Frame& frame, Group& group) {
    const std::size_t axis = group.axis_rays[0] != 0 ? 0u : (group.axis_rays[1] != 0 ? 1u : 2u);
    std::uint64_t alive = group.all();
    std::uint64_t hits = 0;
    Shaft shaft(group, frame, axis);
    bool is_stale = false;
    Entry stack[stack_size];
    std::size_t size = 0;
    stack[size++] = {0, -infinity, alive};
    while (size > 0) {
        const Entry entry = stack[--size];
        const std::uint64_t mask =
            any ? entry.mask & alive : (hits == 0 ? entry.mask : wanting(group, entry.mask, entry.key));
        if (mask == 0) continue;
        // The shaft ends behind the farthest hit, once all rays have one.
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
        // Where few rays are left in each vector they go on one by one.
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

/// The records of a group's rays, in its order.
void write_records(const Group& group, TriangleRecord* records) {
    const hn::RebindToUnsigned<decltype(df)> du;
    for (std::size_t i = 0; i < group.count; i += lanes) {
        const auto triangle = hn::Load(du, group.triangle + i);
        const auto missed = hn::RebindMask(df, hn::Eq(triangle, hn::Set(du, no_triangle)));
        const Floats t = hn::IfThenElse(missed, hn::Set(df, infinity), hn::Load(df, group.limit + i));
        hn::StoreInterleaved4(t, hn::Load(df, group.u + i), hn::Load(df, group.v + i),
                              hn::BitCast(df, triangle), df, reinterpret_cast<float*>(records + i));
    }
}
static_assert(sizeof(TriangleRecord) == 16);

constexpr std::size_t octants = 8;
constexpr std::size_t class_count = 3 * octants; ///< octant × dominant axis
/// Fewer rays than this make no packet.
constexpr std::size_t least_packet = 8;
/// Fewer rays than this of an octant are traced with those of others.
constexpr std::size_t least_stream = 32;

/// Scattered rays that start side by side share more nodes than those of one octant from farther apart,
/// unless they pass much before they hit: measured with scans (crossings of 0.7 to 1.2) and architecture
/// (3.0). Rays that may end at any hit see so little that this pays only where nodes come from memory.
constexpr double most_crossings = 2.0;
constexpr std::size_t large_tree = std::size_t{1} << 25U;

/// Parts a batch into groups and traces them. Tiles of 64 rays of one class go at once, in some trees all
/// tiles do; others' rays wait in the queue of their class until that is full or the batch ends.
template <bool any>
class Batch {
  public:
    using Answer = std::conditional_t<any, std::uint8_t, TriangleRecord>;

    Batch(const MeshTree& tree, const Ray* rays, Answer* answers, BatchForm form)
        : tree_(tree), frame_(tree), rays_(rays), answers_(answers), by_axis_(form == BatchForm::packets),
          mixes_(!by_axis_ && tree.crossings < most_crossings && (!any || tree.bytes() >= large_tree)) {}

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
        const Signs signs = load_tile(group_, frame_, rays_ + at, count);
        const std::uint64_t live = count == group_rays ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
        const std::uint64_t odd = signs.odd & live;
        const std::uint64_t usual = live & ~odd;
        const bool are_alike = usual != 0 && (usual & ~signs.alike(first_bit(usual), by_axis_)) == 0;
        if (std::popcount(odd) < std::popcount(usual) && (are_alike || mixes_)) {
            // A usual ray stands in for each odd one, so that a few of these leave the others together.
            for (std::uint64_t r = signs.odd; r != 0; r &= r - 1)
                stand_in(group_, first_bit(usual), first_bit(r));
            trace_tile(at, count, !are_alike);
        } else {
            sort(at, usual, signs);
        }
        for (std::uint64_t r = odd; r != 0; r &= r - 1) trace_lone(at + first_bit(r));
    }

    /// Puts rays of a tile in the queues of their classes, and traces those that fill.
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

    /// Traces what still waits. Classes of few rays go together, whatever their octants and axes.
    void flush() {
        Queue few;
        std::uint32_t classes = 0;
        for (std::size_t c = 0; c < class_count; ++c) {
            Queue& queue = queues_[c];
            if (queue.count >= (by_axis_ ? least_packet : least_stream)) {
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

    void trace_lone(std::size_t i) {
        if constexpr (any) {
            answers_[i] = occluded_lone(tree_, rays_[i]) ? 1 : 0;
        } else {
            answers_[i] = closest_lone(tree_, rays_[i]);
        }
    }

    std::uint64_t trace_group(bool is_packet) {
        if (is_packet) return trace_packet<any>(tree_, frame_, group_);
        const Sweep sweep(group_, frame_);
        if (group_.is_mixed) return trace_stream<any, true>(tree_, &sweep, group_, 0, group_.all());
        return trace_stream<any>(tree_, &sweep, group_, 0, group_.all());
    }

    void trace_tile(std::size_t at, std::size_t count, bool is_mixed) {
        set_up(group_, frame_, is_mixed);
        const std::uint64_t hits = trace_group(by_axis_ && count >= least_packet);
        if constexpr (any) {
            write_flags(hits, answers_ + at, count);
        } else if (count == group_rays) {
            write_records(group_, answers_ + at);
        } else {
            TriangleRecord found[group_rays];
            write_records(group_, found);
            std::copy_n(found, count, answers_ + at);
        }
    }

    void trace_queue(Queue& queue, bool is_packet, bool is_mixed = false) {
        if (queue.count == 0) return;
        load_numbered(group_, rays_, queue.rays, queue.count);
        set_up(group_, frame_, is_mixed);
        const std::uint64_t hits = trace_group(is_packet);
        if constexpr (any) {
            for (std::size_t i = 0; i < queue.count; ++i) answers_[queue.rays[i]] = hits >> i & 1u;
        } else {
            TriangleRecord found[group_rays];
            write_records(group_, found);
            for (std::size_t i = 0; i < queue.count; ++i) answers_[queue.rays[i]] = found[i];
        }
        queue.count = 0;
    }

    const MeshTree& tree_;
    const Frame frame_;
    const Ray* rays_;
    Answer* answers_;
    bool by_axis_;
    bool mixes_; ///< neighbours stay together, whatever their octants
    Queue queues_[class_count];
    Group group_;
};

} // namespace

// What the table holds: anonymous functions cannot be exported.
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

} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {

const std::array<BatchKernels, kernel_targets> batch_kernels{{
    {HWY_CHOOSE_FALLBACK(closest_batch), HWY_CHOOSE_FALLBACK(occluded_batch)},
    {HWY_CHOOSE_SSE4(closest_batch), HWY_CHOOSE_SSE4(occluded_batch)},
    {HWY_CHOOSE_AVX2(closest_batch), HWY_CHOOSE_AVX2(occluded_batch)},
    {HWY_CHOOSE_AVX3(closest_batch), HWY_CHOOSE_AVX3(occluded_batch)},
}};

} // namespace glint
#endif
