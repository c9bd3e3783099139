// Batches of rays through a MeshTree, for every SIMD target: groups of up to 64 rays of one octant and
// dominant axis go down together, a 64-bit mask for each node telling which of them are there.
//
// Coherent groups are bounded by a shaft that culls eight children at once before any ray is looked at (after
// Reshetov, Soupikov, Hurley 2005 and Boulos, Wald, Benthin 2008); incoherent ones filter ray by ray, each
// node fetched once for all (Barringer and Akenine-Möller, "Dynamic Ray Stream Traversal", 2014). The answer
// is the least (t, triangle), so neither order nor kernel nor vector width shows in it.

#include "trace/kernel_table.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/mesh_batch.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include "trace/mesh_group-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

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

const hn::Half<decltype(df)> dfh;
const hn::Repartition<double, decltype(df)> dd;
using Doubles = hn::Vec<decltype(dd)>;

// ── From rays to groups ──

constexpr std::uint32_t class_count = 24;
constexpr std::uint8_t no_class = 255; ///< NaN, infinite or without direction: hits nothing

/// Octant × dominant axis. The dominant axis is the first of the largest, as in ShearedRay.
std::uint8_t class_of(const Ray& ray) {
    const float zero = (ray.origin.x + ray.origin.y + ray.origin.z) * 0.0f +
                       (ray.direction.x + ray.direction.y + ray.direction.z) * 0.0f;
    const float x = std::abs(ray.direction.x);
    const float y = std::abs(ray.direction.y);
    const float z = std::abs(ray.direction.z);
    const float most = std::max(x, std::max(y, z));
    if (!(zero == 0.0f) || !(most > 0.0f)) return no_class;
    const std::uint32_t axis = x == most ? 0u : (y == most ? 1u : 2u);
    const std::uint32_t octant = (std::signbit(ray.direction.x) ? 1u : 0u) |
                                 (std::signbit(ray.direction.y) ? 2u : 0u) |
                                 (std::signbit(ray.direction.z) ? 4u : 0u);
    return static_cast<std::uint8_t>(axis * 8u + octant);
}

/// Copies rays side by side; places beyond the last repeat it and are masked out everywhere.
void gather(Group& group, const Ray* rays, const std::uint32_t* numbers, std::size_t count,
            float (*direction)[64]) {
    group.count = count;
    for (std::size_t i = 0; i < group_rays; ++i) {
        const std::uint32_t number = numbers[std::min(i, count - 1)];
        const Ray& ray = rays[number];
        for (int axis = 0; axis < 3; ++axis) {
            group.origin[axis][i] = ray.origin[axis];
            direction[axis][i] = ray.direction[axis];
        }
        group.tmin[i] = ray.tmin;
        group.limit[i] = ray.tmax;
        group.source[i] = number;
    }
}

void set_up(Group& group, std::uint8_t ray_class, const Bounds& bounds, const float (*direction)[64]) {
    group.kz = ray_class / 8u;
    group.kx = (group.kz + 1) % 3;
    group.ky = (group.kz + 2) % 3;
    for (std::size_t axis = 0; axis < 3; ++axis) group.negative[axis] = (ray_class >> axis & 1u) != 0;
    const vec3 far = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
    const Floats corner = hn::Set(df, std::max(far.x, std::max(far.y, far.z)));
    const Floats huge = hn::Set(df, std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < group_rays; i += lanes) {
        const Floats dz = hn::Load(df, direction[group.kz] + i);
        Floats reach = hn::Zero(df);
        for (std::size_t axis = 0; axis < 3; ++axis)
            reach = hn::Max(reach, hn::Abs(hn::Load(df, group.origin[axis] + i)));
        const Floats scale = hn::Add(reach, corner);
        const Floats pad = hn::Mul(hn::Set(df, 0x1p-20f), scale);
        const Floats least = hn::Max(hn::Mul(hn::Abs(dz), hn::Set(df, least_direction)),
                                     hn::Mul(scale, hn::Set(df, least_of_scale)));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats d = hn::Load(df, direction[axis] + i);
            const Floats clamped = hn::Max(hn::Abs(d), least);
            const Floats size = hn::Min(hn::Div(hn::Set(df, 1.0f), clamped), huge);
            const Floats inverse = hn::CopySign(size, d);
            const Floats shift = hn::Mul(hn::Load(df, group.origin[axis] + i), inverse);
            const Floats slack = hn::Mul(pad, size);
            hn::Store(inverse, df, group.inverse[axis] + i);
            hn::Store(hn::Neg(hn::Add(shift, slack)), df, group.near_offset[axis] + i);
            hn::Store(hn::Sub(slack, shift), df, group.far_offset[axis] + i);
        }
        hn::Store(hn::Div(hn::Load(df, direction[group.kx] + i), dz), df, group.shear_x + i);
        hn::Store(hn::Div(hn::Load(df, direction[group.ky] + i), dz), df, group.shear_y + i);
        hn::Store(hn::Div(hn::Set(df, 1.0f), dz), df, group.shear_z + i);
        hn::Store(hn::Zero(df), df, group.u + i);
        hn::Store(hn::Zero(df), df, group.v + i);
    }
    for (std::size_t i = 0; i < group_rays; ++i) {
        group.limit[i] = next_float(group.limit[i], -1.0f);
        group.triangle[i] = no_triangle;
    }
}

// ── Leaves ──

/// The same for a ray of a group.
template <bool any>
bool test_member(const Leaf& leaf, Group& group, std::size_t r) {
    Probe probe{group.kx,
                group.ky,
                group.kz,
                group.origin[group.kx][r],
                group.origin[group.ky][r],
                group.origin[group.kz][r],
                group.shear_x[r],
                group.shear_y[r],
                group.shear_z[r],
                group.tmin[r],
                group.limit[r],
                0.0f,
                0.0f,
                group.triangle[r]};
    if (!test_ray<any>(leaf, probe)) return false;
    group.limit[r] = probe.limit;
    group.u[r] = probe.u;
    group.v[r] = probe.v;
    group.triangle[r] = probe.triangle;
    return true;
}

/// What the exact part finds for one vector of rays, as floats; t is infinite where there is no hit.
struct VectorHit {
    Floats t, u, v;
};

struct HalfHit {
    hn::Vec<decltype(dfh)> t, u, v;
};

HalfHit intersect_half(const hn::Vec<decltype(dfh)> (&c)[9], hn::Vec<decltype(dfh)> tmin) {
    const Doubles ax = hn::PromoteTo(dd, c[0]), ay = hn::PromoteTo(dd, c[1]), az = hn::PromoteTo(dd, c[2]);
    const Doubles bx = hn::PromoteTo(dd, c[3]), by = hn::PromoteTo(dd, c[4]), bz = hn::PromoteTo(dd, c[5]);
    const Doubles cx = hn::PromoteTo(dd, c[6]), cy = hn::PromoteTo(dd, c[7]), cz = hn::PromoteTo(dd, c[8]);
    const Doubles u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
    const Doubles v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
    const Doubles w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
    const Doubles zero = hn::Zero(dd);
    const auto mixed =
        hn::And(hn::Lt(hn::Min(u, hn::Min(v, w)), zero), hn::Gt(hn::Max(u, hn::Max(v, w)), zero));
    const Doubles det = hn::Add(hn::Add(u, v), w);
    const Doubles t = hn::Div(hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz)), det);
    // Where det is 0, t is NaN or infinite and no float limit lets it pass.
    const auto good = hn::AndNot(mixed, hn::Gt(t, hn::PromoteTo(dd, tmin)));
    const Doubles far = hn::Set(dd, std::numeric_limits<double>::infinity());
    return {hn::DemoteTo(dfh, hn::IfThenElse(good, t, far)), hn::DemoteTo(dfh, hn::Div(v, det)),
            hn::DemoteTo(dfh, hn::Div(w, det))};
}

/// One vector of rays against a whole leaf: each vertex is sheared once, each triangle tested for all rays.
/// Returns the lanes that hit; for closest hits these are recorded.
template <bool any>
std::uint32_t test_vector(const Leaf& leaf, Group& group, std::size_t first, std::uint32_t live) {
    alignas(32) float x[8][lanes], y[8][lanes], z[8][lanes];
    const Floats ox = hn::Load(df, group.origin[group.kx] + first);
    const Floats oy = hn::Load(df, group.origin[group.ky] + first);
    const Floats oz = hn::Load(df, group.origin[group.kz] + first);
    const Floats sx = hn::Load(df, group.shear_x + first);
    const Floats sy = hn::Load(df, group.shear_y + first);
    const Floats sz = hn::Load(df, group.shear_z + first);
    for (std::uint32_t i = 0; i < leaf.vertices; ++i) {
        const Floats vz = hn::Sub(hn::Set(df, leaf.axis[group.kz][i]), oz);
        const Floats vx = hn::Sub(hn::Sub(hn::Set(df, leaf.axis[group.kx][i]), ox), hn::Mul(sx, vz));
        const Floats vy = hn::Sub(hn::Sub(hn::Set(df, leaf.axis[group.ky][i]), oy), hn::Mul(sy, vz));
        hn::Store(vx, df, x[i]);
        hn::Store(vy, df, y[i]);
        hn::Store(hn::Mul(sz, vz), df, z[i]);
    }
    std::uint32_t hits = 0;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const std::uint32_t word = leaf.corner_word(i);
        const std::uint32_t ka = word & 7u, kb = word >> 3 & 7u, kc = word >> 6 & 7u;
        const Floats ax = hn::Load(df, x[ka]), ay = hn::Load(df, y[ka]);
        const Floats bx = hn::Load(df, x[kb]), by = hn::Load(df, y[kb]);
        const Floats cx = hn::Load(df, x[kc]), cy = hn::Load(df, y[kc]);
        const Floats u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
        const Floats v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
        const Floats w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
        const auto below = hn::Lt(hn::Min(u, hn::Min(v, w)), hn::Zero(df));
        const auto above = hn::Gt(hn::Max(u, hn::Max(v, w)), hn::Zero(df));
        if ((~bits_of(hn::And(below, above)) & live) == 0) continue;

        const Floats az = hn::Load(df, z[ka]), bz = hn::Load(df, z[kb]), cz = hn::Load(df, z[kc]);
        const Floats tmin = hn::Load(df, group.tmin + first);
        const hn::Vec<decltype(dfh)> lower[9] = {
            hn::LowerHalf(dfh, ax), hn::LowerHalf(dfh, ay), hn::LowerHalf(dfh, az),
            hn::LowerHalf(dfh, bx), hn::LowerHalf(dfh, by), hn::LowerHalf(dfh, bz),
            hn::LowerHalf(dfh, cx), hn::LowerHalf(dfh, cy), hn::LowerHalf(dfh, cz)};
        const hn::Vec<decltype(dfh)> upper[9] = {
            hn::UpperHalf(dfh, ax), hn::UpperHalf(dfh, ay), hn::UpperHalf(dfh, az),
            hn::UpperHalf(dfh, bx), hn::UpperHalf(dfh, by), hn::UpperHalf(dfh, bz),
            hn::UpperHalf(dfh, cx), hn::UpperHalf(dfh, cy), hn::UpperHalf(dfh, cz)};
        const HalfHit lo = intersect_half(lower, hn::LowerHalf(dfh, tmin));
        const HalfHit hi = intersect_half(upper, hn::UpperHalf(dfh, tmin));
        const Floats t = hn::Combine(df, hi.t, lo.t);
        const Floats limit = hn::Load(df, group.limit + first);
        std::uint32_t found = bits_of(hn::Le(t, limit)) & live;
        if (found == 0) continue;
        if (any) {
            hits |= found;
            live &= ~found;
            if (live == 0) break;
            continue;
        }
        // Equal t: the lower number stays.
        for (std::uint32_t same = bits_of(hn::Eq(t, limit)) & found; same != 0; same &= same - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(same));
            if (leaf.triangles[i] > group.triangle[first + lane]) found &= ~(1u << lane);
        }
        const auto bits = static_cast<std::uint8_t>(found);
        const std::uint8_t padded[8] = {bits};
        const auto mask = hn::LoadMaskBits(df, padded);
        const hn::RebindToUnsigned<decltype(df)> du;
        hn::Store(hn::IfThenElse(mask, t, limit), df, group.limit + first);
        hn::BlendedStore(hn::Combine(df, hi.u, lo.u), mask, df, group.u + first);
        hn::BlendedStore(hn::Combine(df, hi.v, lo.v), mask, df, group.v + first);
        hn::BlendedStore(hn::Set(du, leaf.triangles[i]), hn::RebindMask(du, mask), du,
                         group.triangle + first);
        hits |= found;
    }
    return hits;
}

/// A leaf for all rays of a mask; returns those that hit.
template <bool any>
std::uint64_t test_leaf(const MeshTree& tree, std::uint32_t code, Group& group, std::uint64_t mask) {
    const Leaf leaf(tree, LeafCode{code});
    std::uint64_t hits = 0;
    for (std::size_t first = 0; first < group_rays; first += lanes) {
        auto live = static_cast<std::uint32_t>(mask >> first) & lane_mask;
        if (live == 0) continue;
        if (std::popcount(live) > 2) {
            hits |= std::uint64_t{test_vector<any>(leaf, group, first, live)} << first;
            continue;
        }
        for (; live != 0; live &= live - 1) {
            const std::size_t r = first + first_bit(live);
            if (test_member<any>(leaf, group, r)) hits |= std::uint64_t{1} << r;
        }
    }
    return hits;
}

// ── Traversal ──

/// Puts the children that rays enter on the stack, the nearest on top.
std::size_t push(const WideNode& node, const Entered& entered, Entry* stack, std::size_t size) {
    const std::size_t base = size;
    for (std::size_t child = 0; child < wide_children; ++child) {
        if (entered.mask[child] == 0) continue;
        const Entry entry{node.child[child], entered.key[child], entered.mask[child]};
        std::size_t at = size++;
        for (; at > base && stack[at - 1].key < entry.key; --at) stack[at] = stack[at - 1];
        stack[at] = entry;
    }
    return size;
}

constexpr std::size_t stack_size = 8 * (max_tree_depth + 1);

template <bool any, bool coherent>
std::uint64_t traverse(const MeshTree& tree, Group& group) {
    std::uint64_t alive =
        group.count == group_rays ? ~std::uint64_t{0} : (std::uint64_t{1} << group.count) - 1;
    std::uint64_t hits = 0;
    Shaft shaft(group, tree.bounds);
    Entry stack[stack_size];
    std::size_t size = 0;
    stack[size++] = {0, -infinity, alive};
    while (size > 0) {
        const Entry entry = stack[--size];
        const std::uint64_t mask = entry.mask & alive;
        if (mask == 0 || (coherent && shaft.is_beyond(entry.key))) continue;
        if ((entry.code & leaf_bit) != 0) {
            const std::uint64_t found = test_leaf<any>(tree, entry.code, group, mask);
            hits |= found;
            if (any) alive &= ~found;
            if (any && alive == 0) break;
            if (coherent && !any && found != 0) shaft.shorten();
            continue;
        }
        const WideNode& node = tree.nodes[entry.code];
        const Planes planes(node, group);
        Entered entered;
        const int live = std::popcount(mask);
        if (coherent) {
            std::uint32_t met = shaft.meets(planes, node, entered.key);
            if (std::popcount(met) * 8 <= live) {
                for (std::size_t child = 0; child < wide_children; ++child)
                    entered.mask[child] =
                        (met >> child & 1u) != 0 ? enter_box(planes, child, group, mask) : 0;
            } else {
                enter_by_ray<false>(planes, group, mask, entered);
            }
        } else {
            enter_by_ray<true>(planes, group, mask, entered);
        }
        size = push(node, entered, stack, size);
    }
    return hits;
}

// ── Batches ──

constexpr std::size_t batch_rays = 4096;

/// Calls body(group, hits) for groups of one class, made from a batch in a stable order.
template <bool any, class Body>
void for_each_group(const MeshTree& tree, const Ray* rays, std::size_t count, BatchForm form, Body&& body) {
    std::uint8_t classes[batch_rays];
    std::uint32_t starts[class_count + 2] = {};
    for (std::size_t i = 0; i < count; ++i) {
        classes[i] = class_of(rays[i]);
        ++starts[std::min<std::uint32_t>(classes[i], class_count) + 1];
    }
    for (std::size_t c = 1; c < class_count + 2; ++c) starts[c] += starts[c - 1];
    std::uint32_t order[batch_rays];
    std::uint32_t next[class_count + 1];
    std::copy_n(starts, class_count + 1, next);
    for (std::size_t i = 0; i < count; ++i)
        order[next[std::min<std::uint32_t>(classes[i], class_count)]++] = static_cast<std::uint32_t>(i);

    Group group;
    alignas(64) float direction[3][group_rays];
    for (std::uint32_t c = 0; c < class_count; ++c) {
        for (std::uint32_t at = starts[c]; at < starts[c + 1]; at += group_rays) {
            gather(group, rays, order + at, std::min<std::size_t>(group_rays, starts[c + 1] - at), direction);
            set_up(group, static_cast<std::uint8_t>(c), tree.bounds, direction);
            const std::uint64_t hits = form == BatchForm::packets ? traverse<any, true>(tree, group)
                                                                  : traverse<any, false>(tree, group);
            body(group, hits);
        }
    }
}

void closest_rays(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                  BatchForm form) {
    for (std::size_t at = 0; at < count; at += batch_rays) {
        const std::size_t n = std::min(batch_rays, count - at);
        std::fill_n(records + at, n, TriangleRecord{});
        if (tree.nodes.empty()) continue;
        for_each_group<false>(tree, rays + at, n, form, [&](const Group& group, std::uint64_t hits) {
            for (; hits != 0; hits &= hits - 1) {
                const std::size_t i = first_bit(hits);
                records[at + group.source[i]] = {group.limit[i], group.u[i], group.v[i], group.triangle[i]};
            }
        });
    }
}

void occluded_rays(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                   BatchForm form) {
    for (std::size_t at = 0; at < count; at += batch_rays) {
        const std::size_t n = std::min(batch_rays, count - at);
        std::fill_n(blocked + at, n, std::uint8_t{0});
        if (tree.nodes.empty()) continue;
        for_each_group<true>(tree, rays + at, n, form, [&](const Group& group, std::uint64_t hits) {
            for (; hits != 0; hits &= hits - 1) blocked[at + group.source[first_bit(hits)]] = 1;
        });
    }
}

} // namespace

// What the dispatcher calls: anonymous functions cannot be exported.
void closest_batch(const MeshTree& tree, const Ray* rays, TriangleRecord* records, std::size_t count,
                   BatchForm form) {
    closest_rays(tree, rays, records, count, form);
}
void occluded_batch(const MeshTree& tree, const Ray* rays, std::uint8_t* blocked, std::size_t count,
                    BatchForm form) {
    occluded_rays(tree, rays, blocked, count, form);
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
}};

} // namespace glint
#endif
