// Whitted's ray tracing as a wavefront.

#include "render/estimators/whitted_wavefront.h"

#include "render/shade_batch.h"

#include <algorithm>

namespace glint::rendering {

using trace::row_of;
using trace::SurfaceRows;
namespace {

vec3 element(const PathStates::Vectors& rows, std::size_t i) { return {rows[0][i], rows[1][i], rows[2][i]}; }

void put(const vec3& v, PathStates::Vectors& rows, std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) rows[static_cast<std::size_t>(axis)][i] = v[axis];
}

template <class T>
std::span<T> part(PathStates::Row<T>& row, Wave wave) {
    return {row.data() + wave.first, wave.count};
}

SurfaceRows surface_rows(PathStates& s, std::size_t first) {
    SurfaceRows rows{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        rows.p[axis] = s.p[axis].data() + first;
        rows.p_error[axis] = s.p_error[axis].data() + first;
        rows.n[axis] = s.n[axis].data() + first;
    }
    return rows;
}

} // namespace

WhittedWavefront::WhittedWavefront(const scene::SceneData& scene, const WhittedSettings& settings,
                                   const CancelFlag* cancel, const KernelChoice& kernel)
    : scene_(scene), modes_(scene::whitted_modes(settings)), max_depth_(settings.max_depth),
      min_weight_(static_cast<float>(settings.min_weight)), cancel_(cancel), kernel_(kernel),
      shade_(shade_kernels[row_of(kernel.target)]), single_(scene, settings, cancel, kernel) {
    background_.emission = scene.background;
}

void WhittedWavefront::estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms) {
    if (states_ == nullptr) states_ = std::make_unique<PathStates>();
    for (std::size_t first = 0; first < samples.size(); first += PathStates::capacity) {
        const std::size_t count = std::min(samples.size() - first, PathStates::capacity);
        estimate_batch(samples.subspan(first, count), out.subspan(first, count), terms);
    }
}

void WhittedWavefront::estimate_batch(std::span<const CameraSample> samples, std::span<Channels> out,
                                      bool terms) {
    start(samples);
    follow({0, samples.size()}, 0);
    if (!is_cancelled()) finish(out, terms);
}

/// Sets the sums of a wave.
void WhittedWavefront::follow(Wave wave, int depth) {
    if (is_cancelled()) return;
    find_hits(wave);
    locate_surfaces(wave);
    for (const LightRecord& light : scene_.lights) add_light(light, wave);
    shade_.limit_terms(modes_, wave, *states_);
    if (depth < max_depth_) follow_branches(wave, depth);
    if (scene_.any_transparent) absorb(wave);
    shade_.sum_terms(wave, *states_);
}

/// Sets the terms of a wave's branches.
void WhittedWavefront::follow_branches(Wave wave, int depth) {
    const std::size_t room = PathStates::capacity - std::min(PathStates::capacity, wave.end());
    // Half of the room is left to their branches.
    const std::size_t at_once = std::min(room / 2, PathStates::max_wave);
    if (at_once < 2 * PathStates::alignment) {
        for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) branch_by_recursion(i, depth);
        return;
    }
    for (std::size_t done = 0; done < wave.count;) {
        const Wave parents = parents_of({wave.first + done, wave.count - done}, at_once);
        done += parents.count;
        const InteriorArena::Scope lists(single_.arena());
        const Wave next = spawn(parents, wave.end(), depth);
        if (next.count == 0) continue;
        follow(next, depth + 1);
        shade_.add_to_parents(next, *states_);
    }
}

/// The first paths of a wave, whole vectors of them, that have at most so many branches.
Wave WhittedWavefront::parents_of(Wave wave, std::size_t branches) const {
    Wave parents{wave.first, 0};
    while (parents.count < wave.count) {
        const std::size_t more = std::min(PathStates::alignment, wave.count - parents.count);
        const std::size_t of_more = max_branches({wave.first + parents.count, more});
        if (of_more > branches) break;
        branches -= of_more;
        parents.count += more;
    }
    return parents;
}

/// Bound on the number of branches of a wave.
std::size_t WhittedWavefront::max_branches(Wave wave) const {
    std::size_t count = 0;
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) {
        const MaterialRecord& m = *states_->materials[i];
        count += m.transparency > 0.0f ? 2 : m.reflectivity > 0.0f ? 1 : 0;
    }
    return count;
}

void WhittedWavefront::start(std::span<const CameraSample> samples) {
    const InteriorList* interior = single_.start();
    counts_.primary += samples.size();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        states_->rays[i] = Ray{};
        states_->rays[i].origin = samples[i].origin;
        states_->rays[i].direction = samples[i].direction;
        states_->interiors[i] = interior;
        put(vec3(1.0f), states_->weights, i);
    }
}

void WhittedWavefront::finish(std::span<Channels> out, bool terms) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i].radiance = element(states_->sums, i);
        out[i].covered = static_cast<bool>(states_->hits[i]);
        if (terms) out[i].terms = terms_at(i);
    }
}

void WhittedWavefront::find_hits(Wave wave) {
    PathStates& s = *states_;
    scene_.world.closest(part(s.rays, wave), part(s.hits, wave), RayHint::coherent, scratch_, kernel_);
    if (scene_.any_transparent || scene_.any_contact)
        for (std::size_t i = wave.first; i < wave.first + wave.count; ++i)
            if (scene_.any_contact || s.interiors[i] != nullptr)
                s.contacts[i] = single_.find_seen(s.rays[i], s.hits[i], s.interiors[i]);
    choose_materials(wave);
    if (scene_.any_transparent) meet_media(wave);
}

void WhittedWavefront::choose_materials(Wave wave) {
    PathStates& s = *states_;
    const scene::ObjectData* objects = scene_.objects.data();
    const MaterialRecord* materials = scene_.materials.data();
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) {
        const MaterialRecord* nothing = s.interiors[i] == nullptr ? &background_ : &darkness_;
        s.materials[i] = s.hits[i] ? &materials[objects[s.hits[i].object].material] : nothing;
    }
    std::fill(&s.materials[wave.first + wave.count], s.materials.data() + wave.end(), &darkness_);
}

void WhittedWavefront::locate_surfaces(Wave wave) {
    PathStates& s = *states_;
    scene_.world.surfaces(part(s.rays, wave), part(s.hits, wave), surface_rows(s, wave.first),
                          part(s.located, wave), kernel_);
    shade_.set_up(wave, s);
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i)
        if (s.hits[i] && (s.located[i] == 0 || needs_attributes(s.hits[i].object) ||
                          (scene_.any_contact && s.contacts[i].exists)))
            put_surface(i);
    shade_.start_terms(scene_.ambient, wave, s);
    if (!scene_.any_front_emission) return;
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i)
        if (s.hits[i])
            put(emitted(*s.materials[i], s.entering[i] != 0.0f),
                s.terms[static_cast<std::size_t>(Term::emission)], i);
}

/// True for objects whose surfaces have more than shape and material: vertex attributes, lit as stored.
bool WhittedWavefront::needs_attributes(std::uint32_t object) const {
    return scene_.objects[object].attributes != scene::no_attributes || scene_.objects[object].lit_as_stored;
}

void WhittedWavefront::put_surface(std::size_t i) {
    PathStates& s = *states_;
    const SurfaceInteraction at = surface_interaction(scene_, s.rays[i], s.hits[i], s.contacts[i]);
    put(at.surface.p, s.p, i);
    put(at.surface.p_error, s.p_error, i);
    put(at.surface.n_g, s.n_g, i);
    put(at.surface.n, s.n, i);
    put(at.surface.color, s.color, i);
    s.entering[i] = at.entering ? 1.0f : 0.0f;
    s.lit_side[i] = at.surface.lit_side;
}

/// Adds one light to all paths that it reaches.
void WhittedWavefront::add_light(const LightRecord& light, Wave wave) {
    PathStates& s = *states_;
    const std::size_t count = shade_.spawn_shadow_rays(modes_, light, wave, s);
    if (count == 0) return;
    counts_.shadow += count;
    scene_.world.occluded(part(s.shadow_rays, wave), part(s.blocked, wave), RayHint::coherent, scratch_,
                          kernel_);
    if (scene_.any_transparent) pass_blockers(wave);
    shade_.add_light(modes_, wave, s);
}

/// Sets the share of blocked light that passes, for paths where any may.
void WhittedWavefront::pass_blockers(Wave wave) {
    PathStates& s = *states_;
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) {
        const bool may_pass = modes_.opaque_shadows == 0 || s.interiors[i] != nullptr || s.lit_side[i] < 0.0f;
        const bool passes = s.blocked[i] != 0 && may_pass;
        put(passes ? single_.light_past_blockers(s.shadow_rays[i], surface_at(i), s.interiors[i])
                   : vec3(0.0f),
            s.passing, i);
    }
}

/// Spawns the branches of a wave from path `first` on.
Wave WhittedWavefront::spawn(Wave parents, std::size_t first, int depth) {
    const Branches mirrored = shade_.spawn_reflected(modes_, min_weight_, parents, first, *states_);
    counts_.reflected += mirrored.followed;
    counts_.left_out += mirrored.left_out;
    Wave next{first, mirrored.followed};
    if (scene_.any_transparent)
        for (std::size_t i = parents.first; i < parents.first + parents.count; ++i)
            if (states_->materials[i]->transparency > 0.0f) spawn_at_glass(i, depth, next);
    return next;
}

void WhittedWavefront::spawn_at_glass(std::size_t i, int depth, Wave& next) {
    const Whitted::Path path = path_at(i, depth);
    const SurfaceInteraction at = surface_at(i);
    weigh_local_terms(i);
    const Bounce bounce = single_.bounce_at(path, at);
    const Split& split = bounce.split;
    const vec3 reflected = at.material->reflected_tint * split.reflected;
    const vec3 refracted = bounce.tint * split.refracted;
    if (single_.follows(path, reflected))
        spawn(single_.reflected_path(path, at, reflected), i, Term::reflection, reflected, next);
    if (single_.follows(path, refracted))
        spawn(single_.refracted_path(path, at, bounce), i, Term::transmission, refracted, next);
}

void WhittedWavefront::spawn(const Whitted::Path& path, std::size_t parent, Term term, const vec3& weight,
                             Wave& next) {
    PathStates& s = *states_;
    const std::size_t i = next.first + next.count++;
    s.rays[i] = Ray{};
    s.rays[i].origin = path.ray.origin;
    s.rays[i].direction = path.ray.direction;
    s.interiors[i] = path.interior;
    put(path.weight, s.weights, i);
    s.parents[i] = static_cast<std::uint32_t>(parent);
    s.parent_terms[i] = term;
    put(weight, s.parent_weights, i);
}

void WhittedWavefront::branch_by_recursion(std::size_t i, int depth) {
    if (!states_->hits[i] || !has_bounces(*states_->materials[i])) return;
    weigh_local_terms(i);
    Terms terms = terms_at(i);
    single_.follow_bounce(path_at(i, depth), surface_at(i), terms);
    put_terms(terms, i);
}

void WhittedWavefront::weigh_local_terms(std::size_t i) {
    const float weight = local_weight(modes_, *states_->materials[i]);
    for (const Term term : {Term::ambient, Term::diffuse, Term::highlight, Term::clamp})
        for (PathStates::Numbers& row : states_->terms[static_cast<std::size_t>(term)]) row[i] *= weight;
}

/// Weighs paths by what the media around them leave of their light.
void WhittedWavefront::meet_media(Wave wave) {
    PathStates& s = *states_;
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) {
        if (s.interiors[i] == nullptr || !s.hits[i]) continue;
        const vec3 left_over = single_.left_by_medium(s.interiors[i], s.hits[i].t);
        put(left_over, s.left_over, i);
        put(element(s.weights, i) * left_over, s.weights, i);
    }
}

void WhittedWavefront::absorb(Wave wave) {
    PathStates& s = *states_;
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) {
        if (s.interiors[i] == nullptr || !s.hits[i]) continue;
        const vec3 left_over = element(s.left_over, i);
        for (PathStates::Vectors& term : s.terms) put(element(term, i) * left_over, term, i);
    }
}

Whitted::Path WhittedWavefront::path_at(std::size_t i, int depth) const {
    const Ray& ray = states_->rays[i];
    return {
        {ray.origin, ray.direction, ray.tmax}, states_->interiors[i], element(states_->weights, i), depth};
}

SurfaceInteraction WhittedWavefront::surface_at(std::size_t i) const {
    const PathStates& s = *states_;
    SurfaceInteraction at;
    at.surface.p = element(s.p, i);
    at.surface.p_error = element(s.p_error, i);
    at.surface.v = element(s.v, i);
    at.surface.n_g = element(s.n_g, i);
    at.surface.n = element(s.n, i);
    at.surface.color = element(s.color, i);
    at.surface.lit_side = s.lit_side[i];
    at.material = s.materials[i];
    at.object = s.hits[i].object;
    at.entering = s.entering[i] != 0.0f;
    at.contact = s.contacts[i];
    return at;
}

Terms WhittedWavefront::terms_at(std::size_t i) const {
    Terms terms;
    for (std::size_t t = 0; t < term_count; ++t) terms.value[t] = element(states_->terms[t], i);
    return terms;
}

void WhittedWavefront::put_terms(const Terms& terms, std::size_t i) {
    for (std::size_t t = 0; t < term_count; ++t) put(terms.value[t], states_->terms[t], i);
}

} // namespace glint::rendering
