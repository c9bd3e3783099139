// Shading for every SIMD target: as many paths at once as a vector holds floats.

#include "render/shade_batch.h"

#include <cstring>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade_batch.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "shading/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::rendering {

using trace::kernel_targets;
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace lanes = glint::HWY_NAMESPACE::lanes;
namespace {

using namespace lanes;
using lanes::integer;
using lanes::LightArrival;
using lanes::LocalTerms;
using lanes::MaterialRecord;
using lanes::real;
using lanes::ShownLight;
using lanes::SpawnedRay;
using lanes::SurfaceRecord;
using lanes::truth;
using lanes::vec3;

HWY_INLINE vec3 load(const PathStates::Vectors& from, std::size_t i) {
    return {lanes::load(&from[0][i]), lanes::load(&from[1][i]), lanes::load(&from[2][i])};
}
HWY_INLINE real load(const PathStates::Numbers& from, std::size_t i) { return lanes::load(&from[i]); }
HWY_INLINE void store(const vec3& x, PathStates::Vectors& to, std::size_t i) {
    lanes::store(x.x, &to[0][i]);
    lanes::store(x.y, &to[1][i]);
    lanes::store(x.z, &to[2][i]);
}
HWY_INLINE void store(real x, PathStates::Numbers& to, std::size_t i) { lanes::store(x, &to[i]); }

HWY_INLINE PathStates::Vectors& row(PathStates& states, Term term) {
    return states.terms[static_cast<std::size_t>(term)];
}

HWY_INLINE void add(const vec3& x, PathStates::Vectors& to, std::size_t i) { store(load(to, i) + x, to, i); }

HWY_INLINE LocalTerms local_terms(PathStates& states, std::size_t i) {
    return {load(row(states, Term::ambient), i), load(row(states, Term::diffuse), i),
            load(row(states, Term::highlight), i), load(row(states, Term::clamp), i)};
}
HWY_INLINE void store(const LocalTerms& local, PathStates& states, std::size_t i) {
    store(local.ambient, row(states, Term::ambient), i);
    store(local.diffuse, row(states, Term::diffuse), i);
    store(local.highlight, row(states, Term::highlight), i);
    store(local.clamp, row(states, Term::clamp), i);
}

/// Calls use(i) for the first path of every vector.
template <class Use>
HWY_INLINE void for_vectors(Wave wave, Use&& use) {
    for (std::size_t i = wave.first; i < wave.first + wave.count; i += lane_count) use(i);
}

// Lists of numbers of a material, for one path or a vector of them: list(material, use) calls use() for each.
// What only glass has is left out: it is shaded by single rays.
constexpr auto surface_numbers = [](auto& m, const auto& use) {
    use(m.color.x);
    use(m.color.y);
    use(m.color.z);
    lanes::for_shading_numbers(m, use);
};
constexpr auto terms_without_lights = [](auto& m, const auto& use) {
    use(m.emission.x);
    use(m.emission.y);
    use(m.emission.z);
    use(m.ambient);
};
constexpr std::size_t max_numbers = shading_numbers + 4;

template <class List>
HWY_INLINE MaterialRecord gather(const glint::MaterialRecord* const* materials, const List& list) {
    alignas(64) float rows[max_numbers][lane_count];
    for (std::size_t k = 0; k < lane_count; ++k) {
        std::size_t n = 0;
        list(*materials[k], [&](float x) { rows[n++][k] = x; });
    }
    MaterialRecord m;
    std::size_t n = 0;
    list(m, [&](real& x) { x = lanes::load(rows[n++]); });
    return m;
}

template <class List>
HWY_INLINE MaterialRecord broadcast(const glint::MaterialRecord& of, const List& list) {
    float numbers[max_numbers];
    std::size_t n = 0;
    list(of, [&](float x) { numbers[n++] = x; });
    MaterialRecord m;
    n = 0;
    list(m, [&](real& x) { x = numbers[n++]; });
    return m;
}

/// Numbers of the materials of one vector of paths. Neighbours mostly lie on one material.
template <class List>
HWY_INLINE MaterialRecord materials_of(const PathStates& states, std::size_t i, const List& list) {
    const glint::MaterialRecord* const* of = &states.materials[i];
    bool one = true;
    for (std::size_t k = 1; k < lane_count; ++k) one &= of[k] == of[0];
    return one ? broadcast(**of, list) : gather(of, list);
}

/// The numbers of the materials that set_up() stored.
HWY_INLINE MaterialRecord stored_materials(const PathStates& states, std::size_t i) {
    MaterialRecord m;
    std::size_t n = 0;
    lanes::for_shading_numbers(m, [&](real& x) { x = load(states.material_numbers[n++], i); });
    return m;
}

HWY_INLINE SurfaceRecord surfaces_of(const PathStates& states, std::size_t i) {
    SurfaceRecord s;
    s.p = load(states.p, i);
    s.p_error = load(states.p_error, i);
    s.v = load(states.v, i);
    s.n_g = load(states.n_g, i);
    s.n = load(states.n, i);
    s.color = load(states.color, i);
    s.lit_side = load(states.lit_side, i);
    return s;
}

/// Rays of a vector, ray by ray: origin and tmin, direction and tmax.
struct RayGroups {
    alignas(64) float origins[4 * lane_count];
    alignas(64) float directions[4 * lane_count];

    HWY_INLINE explicit RayGroups(const SpawnedRay& ray) {
        interleave(ray.origin, 0.0f, origins);
        interleave(ray.direction, ray.tmax, directions);
    }
    HWY_INLINE void copy(std::size_t k, Ray& to) const {
        std::memcpy(&to.origin, origins + 4 * k, 4 * sizeof(float));
        std::memcpy(&to.direction, directions + 4 * k, 4 * sizeof(float));
    }

  private:
    static HWY_INLINE void interleave(const vec3& v, real w, float* to) {
#if HWY_TARGET == HWY_SCALAR
        lanes::store(v.x, to);
        lanes::store(v.y, to + 1);
        lanes::store(v.z, to + 2);
        lanes::store(w, to + 3);
#else
        hn::StoreInterleaved4(v.x.v, v.y.v, v.z.v, w.v, RealTag(), to);
#endif
    }
};

HWY_INLINE vec3 directions_of(const Ray* rays) {
#if HWY_TARGET == HWY_SCALAR
    return vec3(rays->direction);
#else
    // Groups of four: origin and direction of each ray by turns.
    using Floats = hn::Vec<RealTag>;
    const RealTag d;
    Floats x[2], y[2], z[2], t;
    hn::LoadInterleaved4(d, &rays->origin.x, x[0], y[0], z[0], t);
    hn::LoadInterleaved4(d, &rays[lane_count / 2].origin.x, x[1], y[1], z[1], t);
    return {hn::ConcatOdd(d, x[1], x[0]), hn::ConcatOdd(d, y[1], y[0]), hn::ConcatOdd(d, z[1], z[0])};
#endif
}

/// The share of the light that passes what the shadow rays met.
HWY_INLINE vec3 passing_light(const PathStates& states, std::size_t i) {
    const hn::Rebind<std::uint8_t, RealTag> bytes;
    const integer blocked = hn::PromoteTo(IntegerTag(), hn::LoadU(bytes, &states.blocked[i]));
    return pick(real(blocked) == 0.0f, vec3(1.0f), load(states.passing, i));
}

} // namespace

// Called by the dispatcher: functions in an anonymous namespace cannot be exported.
void set_up(Wave wave, PathStates& states) {
    for_vectors(wave, [&](std::size_t i) {
        const vec3 direction = directions_of(&states.rays[i]);
        const vec3 n = load(states.n, i);
        const truth entering = dot(n, direction) < 0.0f;
        const vec3 n_g = pick(entering, n, -n);
        store(n_g, states.n_g, i);
        store(n_g, states.n, i);
        store(-direction, states.v, i);
        store(pick(entering, 1.0f, 0.0f), states.entering, i);
        store(real(1.0f), states.lit_side, i);
        const MaterialRecord m = materials_of(states, i, surface_numbers);
        store(m.color, states.color, i);
        std::size_t number = 0;
        lanes::for_shading_numbers(m, [&](const real& x) { store(x, states.material_numbers[number++], i); });
    });
}

void start_terms(const glm::vec3& ambient_light, Wave wave, PathStates& states) {
    for_vectors(wave, [&](std::size_t i) {
        const MaterialRecord m = materials_of(states, i, terms_without_lights);
        for (PathStates::Vectors& term : states.terms) store(vec3(0.0f), term, i);
        const LocalTerms local = ambient_terms(vec3(ambient_light), surfaces_of(states, i), m);
        store(local.ambient, row(states, Term::ambient), i);
        store(m.emission, row(states, Term::emission), i);
    });
}

std::size_t spawn_shadow_rays(const WhittedModes& modes, const LightRecord& light, Wave wave,
                              PathStates& states) {
    std::size_t count = 0;
    for_vectors(wave, [&](std::size_t i) {
        const SurfaceRecord s = surfaces_of(states, i);
        const LightArrival arrival = light_arrival(light, s);
        const truth reached = is_worth_shadow_ray(modes, s, stored_materials(states, i), arrival);
        store(arrival.direction, states.to_light, i);
        store(pick(reached, arrival.arriving, vec3(0.0f)), states.arriving, i);
        count += hn::CountTrue(RealTag(), reached.m);

        SpawnedRay ray = shadow_ray(light, s, arrival);
        ray.tmax = pick(reached, ray.tmax, -1.0f);
        const RayGroups rays(ray);
        for (std::size_t k = 0; k < lane_count; ++k) rays.copy(k, states.shadow_rays[i + k]);
    });
    return count;
}

void add_light(const WhittedModes& modes, Wave wave, PathStates& states) {
    for_vectors(wave, [&](std::size_t i) {
        LightArrival arrival;
        arrival.direction = load(states.to_light, i);
        arrival.arriving = load(states.arriving, i);
        const vec3 passing = passing_light(states, i);
        if (!any_lane(is_lit(arrival, passing))) return;
        const MaterialRecord m = stored_materials(states, i);
        const ShownLight shown = shown_light(modes, surfaces_of(states, i), m, arrival, passing);
        add(shown.diffuse, row(states, Term::diffuse), i);
        if (any_lane(m.highlight > 0.0f)) add(shown.highlight, row(states, Term::highlight), i);
    });
}

void limit_terms(const WhittedModes& modes, Wave wave, PathStates& states) {
    if (modes.clamp == 0) return;
    for_vectors(wave, [&](std::size_t i) { store(limited_terms(modes, local_terms(states, i)), states, i); });
}

Branches spawn_reflected(const WhittedModes& modes, float min_weight, Wave wave, std::size_t next,
                         PathStates& states) {
    const std::size_t first = next;
    std::size_t mirrors = 0;
    for_vectors(wave, [&](std::size_t i) {
        const MaterialRecord m = stored_materials(states, i);
        const truth mirror = m.reflectivity > 0.0f && !(m.transparency > 0.0f);
        if (!any_lane(mirror)) return;
        store(weighted_terms(local_terms(states, i), pick(mirror, local_weight(modes, m), 1.0f)), states, i);
        const RayGroups rays(reflected_ray(surfaces_of(states, i)));
        const vec3 weights = load(states.weights, i) * (m.reflected_tint * m.reflectivity);
        // Each is written behind the last; what is not followed is written over.
        alignas(64) float followed[lane_count];
        lanes::store(pick(mirror && is_worth_following(weights, min_weight), 1.0f, 0.0f), followed);
        mirrors += hn::CountTrue(RealTag(), mirror.m);
        for (std::size_t k = 0; k < lane_count; ++k) {
            rays.copy(k, states.rays[next]);
            states.interiors[next] = states.interiors[i + k];
            states.parents[next] = static_cast<std::uint32_t>(i + k);
            states.parent_terms[next] = Term::reflection;
            const glint::MaterialRecord& of = *states.materials[i + k];
            const glm::vec3 share = of.reflected_tint * of.reflectivity;
            for (int axis = 0; axis < 3; ++axis) {
                const auto row = static_cast<std::size_t>(axis);
                states.parent_weights[row][next] = share[axis];
                states.weights[row][next] = states.weights[row][i + k] * share[axis];
            }
            next += followed[k] != 0.0f ? 1 : 0;
        }
    });
    return {next - first, mirrors - (next - first)};
}

void sum_terms(Wave wave, PathStates& states) {
    for_vectors(wave, [&](std::size_t i) {
        vec3 sum = load(states.terms[0], i);
        for (std::size_t term = 1; term < term_count; ++term) sum = sum + load(states.terms[term], i);
        store(sum, states.sums, i);
    });
}

void add_to_parents(Wave wave, PathStates& states) {
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            row(states, states.parent_terms[i])[axis][states.parents[i]] =
                states.sums[axis][i] * states.parent_weights[axis][i];
}

} // namespace HWY_NAMESPACE
} // namespace glint::rendering
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint::rendering {

#define GLINT_SHADE_KERNELS(CHOOSE)                                                                          \
    {                                                                                                        \
        CHOOSE(set_up), CHOOSE(start_terms), CHOOSE(spawn_shadow_rays), CHOOSE(add_light),                   \
            CHOOSE(limit_terms), CHOOSE(spawn_reflected), CHOOSE(sum_terms), CHOOSE(add_to_parents)          \
    }
const std::array<ShadeKernels, kernel_targets> shade_kernels{
    {GLINT_SHADE_KERNELS(HWY_CHOOSE_FALLBACK), GLINT_SHADE_KERNELS(HWY_CHOOSE_SSE4),
     GLINT_SHADE_KERNELS(HWY_CHOOSE_AVX2), GLINT_SHADE_KERNELS(HWY_CHOOSE_AVX3)}};
#undef GLINT_SHADE_KERNELS

} // namespace glint::rendering
#endif
