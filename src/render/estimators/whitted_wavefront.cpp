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
    : scene_(scene), modes_(scene::whitted_modes(settings)), max_depth_(settings.max_depth), cancel_(cancel),
      kernel_(kernel), shade_(shade_kernels[row_of(kernel.target)]),
      single_(scene, settings, cancel, kernel) {
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
    waves_.clear();
    for (Wave wave{0, samples.size()}; wave.count > 0;) {
        if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return;
        waves_.push_back(wave);
        find_hits(wave);
        locate_surfaces(wave);
        for (const LightRecord& light : scene_.lights) add_light(light, wave);
        shade_.limit_terms(modes_, wave, *states_);
        wave = spawn(wave, static_cast<int>(waves_.size()) - 1);
    }
    add_up();
    finish(out, terms);
}

void WhittedWavefront::start(std::span<const CameraSample> samples) {
    const InteriorList* interior = single_.start();
    counts_.primary += samples.size();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        states_->rays[i] = Ray{};
        states_->rays[i].origin = samples[i].origin;
        states_->rays[i].direction = samples[i].direction;
        states_->interiors[i] = interior;
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
    if (scene_.any_transparent)
        for (std::size_t i = wave.first; i < wave.first + wave.count; ++i)
            if (s.interiors[i] != nullptr) single_.skip_hidden(s.rays[i], s.hits[i], s.interiors[i]);
    choose_materials(wave);
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
        if (s.hits[i] && (s.located[i] == 0 || needs_attributes(s.hits[i].object))) put_surface(i);
    shade_.start_terms(scene_.ambient, wave, s);
}

/// True for objects whose surfaces have more than shape and material: vertex attributes, lit as stored.
bool WhittedWavefront::needs_attributes(std::uint32_t object) const {
    return scene_.objects[object].attributes != scene::no_attributes || scene_.objects[object].lit_as_stored;
}

void WhittedWavefront::put_surface(std::size_t i) {
    PathStates& s = *states_;
    const SurfaceInteraction at = surface_interaction(scene_, s.rays[i], s.hits[i]);
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
    const std::size_t count = shade_.spawn_shadow_rays(light, wave, s);
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
        s.passing[i] = s.blocked[i] != 0 && may_pass
                           ? single_.light_past_blockers(s.shadow_rays[i], surface_at(i), s.interiors[i])
                           : 0.0f;
    }
}

/// Spawns the branches of a wave: the next wave.
Wave WhittedWavefront::spawn(Wave wave, int depth) {
    Wave next{wave.end(), 0};
    if (depth >= max_depth_) return next;
    const std::size_t max_count = wave.count * (scene_.any_transparent ? 2 : 1);
    if (next.first + max_count > PathStates::capacity) {
        for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) branch_by_recursion(i, depth);
        return next;
    }
    next.count = shade_.spawn_reflected(modes_, wave, next.first, *states_);
    counts_.reflected += next.count;
    if (scene_.any_transparent)
        for (std::size_t i = wave.first; i < wave.first + wave.count; ++i)
            if (states_->materials[i]->transparency > 0.0f) spawn_at_glass(i, depth, next);
    return next;
}

void WhittedWavefront::spawn_at_glass(std::size_t i, int depth, Wave& next) {
    const Whitted::Path path = path_at(i, depth);
    const SurfaceInteraction at = surface_at(i);
    weigh_local_terms(i);
    const Bounce bounce = single_.bounce_at(path, at);
    const Split& split = bounce.split;
    if (split.reflected > 0.0f)
        spawn(single_.reflected_path(path, at), i, Term::reflection, split.reflected, next);
    if (split.refracted > 0.0f)
        spawn(single_.refracted_path(path, at, bounce), i, Term::transmission, split.refracted, next);
}

void WhittedWavefront::spawn(const Whitted::Path& path, std::size_t parent, Term term, float weight,
                             Wave& next) {
    PathStates& s = *states_;
    const std::size_t i = next.first + next.count++;
    s.rays[i] = Ray{};
    s.rays[i].origin = path.ray.origin;
    s.rays[i].direction = path.ray.direction;
    s.interiors[i] = path.interior;
    s.parents[i] = static_cast<std::uint32_t>(parent);
    s.parent_terms[i] = term;
    s.parent_weights[i] = weight;
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

/// Sums the paths' terms, including those from branches, the deepest wave first.
void WhittedWavefront::add_up() {
    for (std::size_t n = waves_.size(); n-- > 0;) {
        if (scene_.any_transparent) absorb(waves_[n]);
        shade_.sum_terms(waves_[n], *states_);
        if (n > 0) shade_.add_to_parents(waves_[n], *states_);
    }
}

void WhittedWavefront::absorb(Wave wave) {
    PathStates& s = *states_;
    for (std::size_t i = wave.first; i < wave.first + wave.count; ++i) {
        if (s.interiors[i] == nullptr || !s.hits[i]) continue;
        Terms terms = terms_at(i);
        single_.absorb(s.interiors[i], s.hits[i].t, terms);
        put_terms(terms, i);
    }
}

Whitted::Path WhittedWavefront::path_at(std::size_t i, int depth) const {
    const Ray& ray = states_->rays[i];
    return {{ray.origin, ray.direction, ray.tmax}, states_->interiors[i], depth};
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
