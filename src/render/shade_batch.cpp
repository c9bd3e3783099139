// Shading for every SIMD target, as many flights at once as floats fit into a vector.

#include "render/shade_batch.h"

#include <cstring>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade_batch.cpp"
#include <hwy/foreach_target.h> // IWYU pragma: keep

#include <hwy/highway.h>

#include "shading/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
namespace {

using namespace lanes;
using lanes::real;
using lanes::vec3;

HWY_INLINE vec3 load(const Flights::Vectors& from, std::size_t i) {
    return {lanes::load(&from[0][i]), lanes::load(&from[1][i]), lanes::load(&from[2][i])};
}
HWY_INLINE real load(const Flights::Numbers& from, std::size_t i) { return lanes::load(&from[i]); }
HWY_INLINE void store(const vec3& x, Flights::Vectors& to, std::size_t i) {
    lanes::store(x.x, &to[0][i]);
    lanes::store(x.y, &to[1][i]);
    lanes::store(x.z, &to[2][i]);
}
HWY_INLINE void store(real x, Flights::Numbers& to, std::size_t i) { lanes::store(x, &to[i]); }

HWY_INLINE Flights::Vectors& row(Flights& flights, Term term) {
    return flights.terms[static_cast<std::size_t>(term)];
}

/// Calls use(i) for the first flight of every vector.
template <class Use>
HWY_INLINE void for_vectors(Level level, Use&& use) {
    for (std::size_t i = level.first; i < level.first + level.count; i += lane_count) use(i);
}

/// One number of each flight's material.
HWY_INLINE real of_materials(const FrozenMaterial* const* materials, float FrozenMaterial::*number) {
    alignas(64) float numbers[lane_count];
    for (std::size_t k = 0; k < lane_count; ++k) numbers[k] = materials[k]->*number;
    return lanes::load(numbers);
}
HWY_INLINE vec3 of_materials(const FrozenMaterial* const* materials, glm::vec3 FrozenMaterial::*numbers) {
    alignas(64) float rows[3][lane_count];
    for (std::size_t k = 0; k < lane_count; ++k)
        for (int axis = 0; axis < 3; ++axis) rows[axis][k] = (materials[k]->*numbers)[axis];
    return {lanes::load(rows[0]), lanes::load(rows[1]), lanes::load(rows[2])};
}

/// What shading needs of the materials of one vector of flights.
struct Materials {
    vec3 color, emission;
    real ambient, diffuse, highlight, shininess, reflectivity, transparency;

    explicit Materials(const FrozenMaterial* const* of) {
        using M = FrozenMaterial;
        color = of_materials(of, &M::color);
        emission = of_materials(of, &M::emission);
        ambient = of_materials(of, &M::ambient);
        diffuse = of_materials(of, &M::diffuse);
        highlight = of_materials(of, &M::highlight);
        shininess = of_materials(of, &M::shininess);
        reflectivity = of_materials(of, &M::reflectivity);
        transparency = of_materials(of, &M::transparency);
    }
    explicit Materials(const FrozenMaterial& m)
        : color(m.color), emission(m.emission), ambient(m.ambient), diffuse(m.diffuse),
          highlight(m.highlight), shininess(m.shininess), reflectivity(m.reflectivity),
          transparency(m.transparency) {}
};

/// Neighbours mostly lie on one material.
HWY_INLINE Materials materials_of(const Flights& flights, std::size_t i) {
    const FrozenMaterial* const* of = &flights.materials[i];
    bool one = true;
    for (std::size_t k = 1; k < lane_count; ++k) one &= of[k] == of[0];
    return one ? Materials(**of) : Materials(of);
}

/// Rays of a vector, ray by ray: origin and tmin, direction and tmax.
struct RayGroups {
    alignas(64) float origins[4 * lane_count];
    alignas(64) float directions[4 * lane_count];

    HWY_INLINE RayGroups(const vec3& origin, const vec3& direction, real tmax) {
        interleave(origin, 0.0f, origins);
        interleave(direction, tmax, directions);
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

LightArrival arrival_from(const FrozenLight& light, const vec3& p, const vec3& n, const vec3& n_g) {
    const vec3 strength(light.strength);
    if (light.kind == LightKind::directional) {
        LightArrival arrival;
        arrival.direction = vec3(-light.direction);
        arrival.cosine = light_cosine(n, n_g, arrival.direction);
        arrival.arriving = directional_light_arriving(strength, arrival.cosine);
        return arrival;
    }
    LightArrival arrival = arrival_from_point(vec3(light.position), strength, p, n, n_g);
    if (light.kind == LightKind::spot)
        arrival.arriving = arrival.arriving * spot_falloff(-dot(arrival.direction, vec3(light.direction)),
                                                           light.cos_outer, light.cos_inner);
    return arrival;
}

HWY_INLINE truth is_light(const vec3& arriving) {
    return !((arriving.x == 0.0f) & (arriving.y == 0.0f) & (arriving.z == 0.0f));
}

/// The share of the light that passes what the shadow rays met.
HWY_INLINE real shadow_factor(const Flights& flights, std::size_t i) {
    const hn::Rebind<std::uint8_t, RealTag> bytes;
    const integer blocked = hn::PromoteTo(IntegerTag(), hn::LoadU(bytes, &flights.blocked[i]));
    return pick(real(blocked) == 0.0f, 1.0f, load(flights.through, i));
}

} // namespace

// What the dispatcher calls: anonymous functions cannot be exported.
void set_up(const FrozenScene&, Level level, Flights& f) {
    for_vectors(level, [&](std::size_t i) {
        const vec3 direction = directions_of(&f.rays[i]);
        const vec3 n = load(f.n, i);
        const truth entering = dot(n, direction) < 0.0f;
        const vec3 n_g = pick(entering, n, -n);
        store(n_g, f.n_g, i);
        store(n_g, f.n, i);
        store(-direction, f.v, i);
        store(pick(entering, 1.0f, 0.0f), f.entering, i);
        store(real(1.0f), f.lit_side, i);
        const Materials m = materials_of(f, i);
        store(m.color, f.color, i);
        store(m.diffuse, f.diffuse, i);
        store(m.highlight, f.highlight, i);
        store(m.shininess, f.shininess, i);
        store(m.reflectivity, f.reflectivity, i);
        store(m.transparency, f.transparency, i);
    });
}

void start_terms(const FrozenScene& scene, Level level, Flights& f) {
    for_vectors(level, [&](std::size_t i) {
        const Materials m = materials_of(f, i);
        for (Flights::Vectors& term : f.terms) store(vec3(0.0f), term, i);
        store(ambient_term(vec3(scene.ambient), load(f.color, i), m.ambient), row(f, Term::ambient), i);
        store(m.emission, row(f, Term::emission), i);
    });
}

std::size_t aim(const FrozenScene&, const FrozenLight& light, Level level, Flights& f) {
    const bool has_place = light.kind != LightKind::directional;
    const float tmax = has_place ? 1.0f : std::numeric_limits<float>::infinity();
    std::size_t count = 0;
    for_vectors(level, [&](std::size_t i) {
        const real side = load(f.lit_side, i);
        const vec3 p = load(f.p, i);
        const vec3 n_g = load(f.n_g, i);
        const LightArrival arrival = arrival_from(light, p, load(f.n, i) * side, n_g * side);
        const truth shines = (load(f.diffuse, i) > 0.0f) | (load(f.highlight, i) > 0.0f);
        const vec3 arriving = pick(shines, arrival.arriving, vec3(0.0f));
        const truth reached = is_light(arriving);
        store(arrival.direction, f.to_light, i);
        store(arriving, f.arriving, i);
        count += hn::CountTrue(RealTag(), reached.m);

        const vec3 origin = offset_ray_origin(p, load(f.p_error, i), n_g, arrival.direction);
        const vec3 direction = has_place ? vec3(light.position) - origin : arrival.direction;
        const RayGroups rays(origin, direction, pick(reached, tmax, -1.0f));
        for (std::size_t k = 0; k < lane_count; ++k) rays.copy(k, f.shadow_rays[i + k]);
    });
    return count;
}

void add_light(const FrozenScene& scene, Level level, Flights& f) {
    const WhittedSettings& settings = scene.description.whitted;
    for_vectors(level, [&](std::size_t i) {
        const vec3 arriving = load(f.arriving, i);
        const real factor = shadow_factor(f, i);
        const truth lit = is_light(arriving) & (factor > 0.0f);
        if (!any(lit)) return;
        vec3 diffuse = diffuse_term(arriving, load(f.color, i), load(f.diffuse, i)) * factor;
        if (settings.clamp) diffuse = limit_to_one(diffuse);
        Flights::Vectors& diffuse_row = row(f, Term::diffuse);
        const vec3 before = load(diffuse_row, i);
        store(pick(lit, before + diffuse, before), diffuse_row, i);

        const real k = load(f.highlight, i);
        const truth glossy = lit & (k > 0.0f);
        if (!any(glossy)) return;
        const vec3 n = load(f.n, i) * load(f.lit_side, i);
        const vec3 l = load(f.to_light, i);
        const vec3 v = load(f.v, i);
        const real m = load(f.shininess, i);
        const real lobe = settings.highlight_model == HighlightModel::blinn ? blinn_lobe(n, l, v, m)
                                                                            : phong_lobe(n, l, v, m);
        Flights::Vectors& highlight_row = row(f, Term::highlight);
        const vec3 dark = load(highlight_row, i);
        store(pick(glossy, dark + highlight_term(arriving, k, lobe) * factor, dark), highlight_row, i);
    });
}

void limit_terms(const FrozenScene& scene, Level level, Flights& f) {
    if (!scene.description.whitted.clamp) return;
    for_vectors(level, [&](std::size_t i) {
        const vec3 ambient = limit_to_range(load(row(f, Term::ambient), i));
        const vec3 highlight = limit_to_range(load(row(f, Term::highlight), i));
        const vec3 sum = (ambient + load(row(f, Term::diffuse), i)) + highlight;
        store(ambient, row(f, Term::ambient), i);
        store(highlight, row(f, Term::highlight), i);
        store(limit_to_one(sum) - sum, row(f, Term::clamp), i);
    });
}

std::size_t reflect(const FrozenScene& scene, Level level, std::size_t next, Flights& f) {
    const bool balanced = scene.description.whitted.energy == Energy::balanced;
    const std::size_t first = next;
    for_vectors(level, [&](std::size_t i) {
        const real weight = load(f.reflectivity, i);
        const real transparency = load(f.transparency, i);
        const truth mirror = (weight > 0.0f) & !(transparency > 0.0f);
        if (!any(mirror)) return;
        const real local = local_weight(weight, transparency, balanced);
        for (const Term term : {Term::ambient, Term::diffuse, Term::highlight, Term::clamp}) {
            const vec3 whole = load(row(f, term), i);
            store(pick(mirror, whole * local, whole), row(f, term), i);
        }
        const vec3 n_g = load(f.n_g, i);
        const vec3 direction = mirror_ray_direction(load(f.v, i), load(f.n, i), n_g);
        const vec3 origin = offset_ray_origin(load(f.p, i), load(f.p_error, i), n_g, direction);
        const RayGroups rays(origin, direction, std::numeric_limits<float>::infinity());
        // Each is written behind the last; what does not go on is written over.
        alignas(64) float goes_on[lane_count];
        lanes::store(pick(mirror, 1.0f, 0.0f), goes_on);
        for (std::size_t k = 0; k < lane_count; ++k) {
            rays.copy(k, f.rays[next]);
            f.media[next] = f.media[i + k];
            f.parents[next] = static_cast<std::uint32_t>(i + k);
            f.branches[next] = Term::reflection;
            f.weights[next] = f.reflectivity[i + k];
            next += goes_on[k] != 0.0f ? 1 : 0;
        }
    });
    return next - first;
}

void sum_terms(Level level, Flights& f) {
    for_vectors(level, [&](std::size_t i) {
        vec3 sum = load(f.terms[0], i);
        for (std::size_t term = 1; term < term_count; ++term) sum = sum + load(f.terms[term], i);
        store(sum, f.sums, i);
    });
}

void bring(Level level, Flights& f) {
    for (std::size_t i = level.first; i < level.first + level.count; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            row(f, f.branches[i])[axis][f.parents[i]] = f.sums[axis][i] * f.weights[i];
}

} // namespace HWY_NAMESPACE
} // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {

#define GLINT_SHADE_KERNELS(CHOOSE)                                                                          \
    {                                                                                                        \
        CHOOSE(set_up), CHOOSE(start_terms), CHOOSE(aim), CHOOSE(add_light), CHOOSE(limit_terms),            \
            CHOOSE(reflect), CHOOSE(sum_terms), CHOOSE(bring)                                                \
    }
const std::array<ShadeKernels, kernel_targets> shade_kernels{
    {GLINT_SHADE_KERNELS(HWY_CHOOSE_FALLBACK), GLINT_SHADE_KERNELS(HWY_CHOOSE_SSE4),
     GLINT_SHADE_KERNELS(HWY_CHOOSE_AVX2), GLINT_SHADE_KERNELS(HWY_CHOOSE_AVX3)}};
#undef GLINT_SHADE_KERNELS

} // namespace glint
#endif
