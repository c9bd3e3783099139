// Whitted's ray tracing, one ray after another.

#include "render/estimators/whitted.h"

#include "glint/error.h"
#include "parallel/stack.h"
#include "render/ray_recorder.h"
#include "shading/interaction.shared.h"

#include <algorithm>
#include <optional>
#include <string>

namespace glint::rendering {

using scene::SceneData;
using trace::Hit;
using trace::PrimKind;
namespace {

/// Throws before the recursion runs out of stack.
void require_stack(int max_depth) {
    constexpr std::size_t one_level = std::size_t{64} << 10U; // more than a level and what it calls need
    if (parallel::stack_left() >= one_level) return;
    throw Error(ErrorKind::resource,
                "the stack of a thread is too small for max_depth = " + std::to_string(max_depth),
                "lower max_depth, or raise the limit of the stack: ulimit -s unlimited");
}

/// The vectors at the corners of a triangle, as columns.
mat3 at_corners(const std::vector<vec3>& vectors, const uvec3& corner) {
    return {vectors[corner.x], vectors[corner.y], vectors[corner.z]};
}

/// Colour and shading normal, where the mesh has them by vertex. A cloud of spheres has a colour for each.
void interpolate_vertices(const SceneData& scene, const Hit& hit, SurfaceRecord& s) {
    const scene::ObjectData& object = scene.objects[hit.object];
    const scene::MeshAttributes& attributes = scene.attributes[static_cast<std::size_t>(object.attributes)];
    if (hit.kind == PrimKind::quadric) {
        s.color = attributes.mesh->colors[hit.prim];
        return;
    }
    const uvec3 corner = attributes.mesh->triangles[hit.prim];
    if (attributes.colored) s.color = interpolated(at_corners(attributes.mesh->colors, corner), hit.u, hit.v);
    if (attributes.normals == nullptr) return;
    mat3 normals = at_corners(*attributes.normals, corner);
    if (object.normal_matrix != scene::no_normal_matrix)
        normals = transformed_normals(scene.normal_matrices[static_cast<std::size_t>(object.normal_matrix)],
                                      normals);
    s.n = shading_normal(interpolated(normals, hit.u, hit.v), s.n_g);
}

} // namespace

SurfaceInteraction surface_interaction(const SceneData& scene, const Ray& ray, const Hit& hit,
                                       const Contact& contact) {
    const scene::ObjectData& object = scene.objects[hit.object];
    SurfacePoint point = scene.world.surface(ray, hit);
    point.p_error = point.p_error + vec3(contact.margin);
    SurfaceInteraction at;
    at.contact = contact;
    at.object = hit.object;
    at.material = &scene.materials[object.material];
    at.entering = enters(point.n, ray.direction);
    at.surface =
        surface_record(point, ray.direction, at.material->color, object.lit_as_stored, object.turned);
    if (object.attributes != scene::no_attributes) interpolate_vertices(scene, hit, at.surface);
    return at;
}

Whitted::Whitted(const SceneData& scene, const WhittedSettings& settings, const CancelFlag* cancel,
                 const KernelChoice& kernel)
    : scene_(scene), modes_(scene::whitted_modes(settings)), max_depth_(settings.max_depth),
      min_weight_(static_cast<float>(settings.min_weight)), cancel_(cancel), kernel_(kernel),
      ends_shadow_([&scene](const Hit& hit) {
          return !(scene.materials[scene.objects[hit.object].material].transparency > 0.0f);
      }) {}

void Whitted::estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool) {
    for (std::size_t i = 0; i < samples.size(); ++i) out[i] = trace(samples[i]);
}

Channels Whitted::trace(const CameraSample& sample, RayTree* record) {
    std::optional<RayRecorder> recorder;
    if (record != nullptr) recorder.emplace(*record);
    recorder_ = record != nullptr ? &*recorder : nullptr;
    ++counts_.primary;
    const Channels out = radiance({{sample.origin, sample.direction, infinite_t()}, start()});
    recorder_ = nullptr;
    return out;
}

const InteriorList* Whitted::start() {
    arena_.clear();
    const InteriorList* interior = nullptr;
    for (const std::uint32_t object : scene_.camera_interiors)
        interior = entered(interior, object, scene_, arena_);
    return interior;
}

Channels Whitted::radiance(Path&& path) {
    Channels out;
    // A tree can have 2^max_depth rays: cancelling must reach into it.
    if (cancelled()) return out;
    require_stack(max_depth_);
    const InteriorArena::Scope lists(arena_);
    if (recorder_ != nullptr) recorder_->begin_ray(path.kind, path.depth, path.ray);

    // Find the closest surface that no solid of higher rank hides.
    const Ray ray = ray_of(path.ray);
    Hit hit = scene_.world.closest(ray, kernel_);
    const Contact contact = find_seen(ray, hit, path.interior);
    out.covered = static_cast<bool>(hit);

    if (!hit) {
        // The background shows, but not to a ray that never leaves a solid.
        if (path.interior == nullptr) out.terms[Term::emission] = scene_.background;
        if (recorder_ != nullptr) recorder_->miss(solids_of(path.interior, scene_));
    } else {
        const SurfaceInteraction at = surface_interaction(scene_, ray, hit, contact);
        if (recorder_ != nullptr) recorder_->hit(hit, at, solids_of(path.interior, scene_));
        const vec3 left_over = left_by_medium(path.interior, hit.t);
        path.weight = path.weight * left_over;

        // Add up the light that arrives from the lights.
        LocalTerms local = local_light(path, at);
        out.terms[Term::emission] = emitted(*at.material, at.entering);

        // Follow the mirror and the refracted ray.
        if (bounces(path, at)) {
            local = weighted_terms(local, local_weight(modes_, *at.material));
            follow_bounce(path, at, out.terms);
        }
        out.terms[Term::ambient] = local.ambient;
        out.terms[Term::diffuse] = local.diffuse;
        out.terms[Term::highlight] = local.highlight;
        out.terms[Term::clamp] = local.clamp;

        // Absorb what comes back through the medium.
        for (vec3& value : out.terms.value) value = value * left_over;
        if (recorder_ != nullptr) recorder_->absorb(left_over);
    }
    out.radiance = out.terms.sum();
    if (recorder_ != nullptr) recorder_->end_ray(out);
    return out;
}

Contact Whitted::find_seen(const Ray& ray, Hit& hit, const InteriorList*& interior) {
    while (hit && (interior != nullptr || may_coincide(scene_, ray, hit))) {
        find_coincident(scene_, ray, hit, met_);
        const Hit* seen = seen_of(met_.hits, interior, scene_);
        if (recorder_ != nullptr)
            for (const Hit& met : met_.hits)
                if (&met != seen) recorder_->pass_over(met);
        if (seen != nullptr) {
            hit = *seen;
            return met_.hits.size() > 1 ? contact_of_met(ray, *seen, interior) : Contact{};
        }
        for (const Hit& met : met_.hits) cross(ray, met, interior);
        hit = scene_.world.next(ray, met_.hits.back());
    }
    return {};
}

/// What is met in the place of `met_`.
Contact Whitted::contact_of_met(const Ray& ray, const Hit& seen, const InteriorList* interior) {
    Contact contact;
    contact.exists = true;
    contact.margin = met_.margin;
    contact.beyond = interior;
    for (const Hit& met : met_.hits) {
        cross(ray, met, contact.beyond);
        contact.refracts = contact.refracts || is_dielectric(met.object, scene_);
        if (&met == &seen || !dims_light(met, met_.hits, interior, scene_)) continue;
        contact.others = contact.others * material_of(met).transparency;
        contact.tint = contact.tint * material_of(met).transmitted_tint;
    }
    return contact;
}

const InteriorList* Whitted::beyond(const SurfaceInteraction& at, const InteriorList* interior) {
    if (at.contact.exists) return at.contact.beyond;
    if (!is_dielectric(at.object, scene_)) return interior;
    return crossed(interior, at.object, at.entering, scene_, arena_);
}

void Whitted::cross(const Ray& ray, const Hit& hit, const InteriorList*& interior) {
    if (!is_dielectric(hit.object, scene_)) return;
    const bool entering = enters(scene_.world.surface(ray, hit).n, ray.direction);
    interior = crossed(interior, hit.object, entering, scene_, arena_);
}

LocalTerms Whitted::local_light(const Path& path, const SurfaceInteraction& at) {
    LocalTerms local = ambient_terms(scene_.ambient, at.surface, *at.material);
    for (const LightRecord& light : scene_.lights) {
        const LightArrival arrival = light_arrival(light, at.surface);
        if (recorder_ != nullptr) recorder_->begin_light(arrival);
        // A recorder gets the shadows outside the highlight too.
        if (recorder_ != nullptr ? !reflects_light(*at.material, arrival)
                                 : !is_worth_shadow_ray(modes_, at.surface, *at.material, arrival))
            continue;
        const vec3 passing = light_passing(light, arrival, path, at);
        const ShownLight shown = shown_light(modes_, at.surface, *at.material, arrival, passing);
        local = with_light(local, shown);
        if (recorder_ != nullptr) recorder_->end_light(passing, shown);
    }
    return limited_terms(modes_, local);
}

/// The share of a light that reaches a surface.
vec3 Whitted::light_passing(const LightRecord& light, const LightArrival& arrival, const Path& path,
                            const SurfaceInteraction& at) {
    const Ray shadow = ray_of(shadow_ray(light, at.surface, arrival));
    ++counts_.shadow;
    if (recorder_ != nullptr) recorder_->shadow_ray(shadow);
    if (!scene_.world.occluded(shadow, kernel_)) return vec3(1.0f);
    return light_past_blockers(shadow, at, path.interior);
}

vec3 Whitted::light_past_blockers(const Ray& shadow, const SurfaceInteraction& at,
                                  const InteriorList* interior) {
    const InteriorArena::Scope lists(arena_);
    // Light on a back that is lit as stored arrives on the other side of the surface.
    if (at.surface.lit_side < 0.0f) interior = beyond(at, interior);
    return light_past_blockers(shadow, interior);
}

vec3 Whitted::light_past_blockers(const Ray& shadow, const InteriorList* interior) {
    const InteriorArena::Scope lists(arena_);
    const bool may_pass = scene_.any_transparent && (modes_.opaque_shadows == 0 || interior != nullptr);
    // If no light can pass, only the recorder needs the blockers.
    if (!may_pass && recorder_ == nullptr) return vec3(0.0f);
    const vec3 passing = walk_shadow(shadow, interior);
    return may_pass ? passing : vec3(0.0f);
}

/// The product of the surfaces' shares. A recorder gets those behind the first opaque one too.
vec3 Whitted::walk_shadow(const Ray& shadow, const InteriorList* interior) {
    static const trace::EndsSearch never;
    if (!scene_.world.all_hits(shadow, blockers_, recorder_ == nullptr ? ends_shadow_ : never))
        return vec3(0.0f);
    const bool hides = any_may_be_hidden(blockers_, interior);
    vec3 passing(1.0f);
    for (std::size_t i = 0; i < blockers_.size(); i += met_.hits.size()) {
        find_coincident(scene_, shadow, blockers_[i], met_);
        for (const Hit& met : met_.hits) {
            const bool dims = dims_light(met, met_.hits, interior, scene_);
            if (recorder_ != nullptr) recorder_->blocker(met, material_of(met).transparency, !dims);
            if (dims) passing = passing * shadow_transmittance(modes_, material_of(met));
        }
        if (is_dark(passing) && recorder_ == nullptr) return vec3(0.0f);
        if (!hides) continue;
        for (const Hit& met : met_.hits) cross(shadow, met, interior);
    }
    return passing;
}

/// False if no hit is of a lower rank than a solid that the ray is in or enters: then none is hidden, and the
/// list need not be kept.
bool Whitted::any_may_be_hidden(std::span<const Hit> hits, const InteriorList* interior) const {
    std::uint32_t highest = 0;
    if (interior != nullptr) highest = scene_.objects[interior->owner].rank;
    for (const Hit& hit : hits)
        if (is_dielectric(hit.object, scene_)) highest = std::max(highest, scene_.objects[hit.object].rank);
    return std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
        return is_dielectric(hit.object, scene_) && scene_.objects[hit.object].rank < highest;
    });
}

bool Whitted::bounces(const Path& path, const SurfaceInteraction& at) {
    const bool goes_on = has_bounces(*at.material);
    if (goes_on && path.depth < max_depth_) return true;
    if (recorder_ != nullptr) recorder_->end_at(goes_on ? RayEnd::depth_limit : RayEnd::matte);
    return false;
}

void Whitted::follow_bounce(const Path& path, const SurfaceInteraction& at, Terms& terms) {
    const Bounce bounce = bounce_at(path, at);
    const Split& split = bounce.split;
    if (recorder_ != nullptr) recorder_->bounce(local_weight(modes_, *at.material), bounce, *at.material);
    const vec3 reflected = at.material->reflected_tint * split.reflected;
    const vec3 refracted = bounce.tint * split.refracted;
    if (follows(path, reflected))
        terms[Term::reflection] = radiance(reflected_path(path, at, reflected)).radiance * reflected;
    if (follows(path, refracted))
        terms[Term::transmission] = radiance(refracted_path(path, at, bounce)).radiance * refracted;
}

Bounce Whitted::bounce_at(const Path& path, const SurfaceInteraction& at) {
    Bounce bounce;
    bounce.interior = beyond(at, path.interior);
    bounce.tint = at.material->transmitted_tint * at.contact.tint;
    if (!is_dielectric(at.object, scene_) && !at.contact.refracts) {
        bounce.split = split_at_sheet(at.surface, *at.material);
        bounce.split.refracted *= at.contact.others;
        return bounce;
    }
    const float index_before = refractive_index(path.interior, scene_);
    const float index_after = refractive_index(bounce.interior, scene_);
    const Refraction refraction = refraction_at(at.surface, index_before / index_after);
    bounce.split = split_at_solid(*at.material, refraction, index_before, index_after);
    bounce.split.refracted *= at.contact.others;
    if (recorder_ != nullptr) recorder_->refract(refraction, index_before, index_after);
    return bounce;
}

bool Whitted::follows(const Path& path, const vec3& share) {
    if (is_dark(share)) return false;
    if (is_worth_following(path.weight * share, min_weight_)) return true;
    ++counts_.left_out;
    return false;
}

Whitted::Path Whitted::reflected_path(const Path& path, const SurfaceInteraction& at, const vec3& share) {
    ++counts_.reflected;
    return {reflected_ray(at.surface), path.interior, path.weight * share, path.depth + 1,
            RayKind::reflected};
}

Whitted::Path Whitted::refracted_path(const Path& path, const SurfaceInteraction& at, const Bounce& bounce) {
    ++counts_.refracted;
    return {spawn_ray(at.surface, bounce.split.direction), bounce.interior,
            path.weight * (bounce.tint * bounce.split.refracted), path.depth + 1, RayKind::refracted};
}

vec3 Whitted::left_by_medium(const InteriorList* interior, float distance) const {
    if (interior == nullptr) return vec3(1.0f);
    const vec3& sigma = scene_.materials[scene_.objects[interior->owner].material].absorption;
    return sigma == vec3(0.0f) ? vec3(1.0f) : transmittance(sigma, distance);
}

} // namespace glint::rendering
