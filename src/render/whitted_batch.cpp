// Many camera rays at once, breadth first: every level's rays are traced together, then light by light its
// shadow rays, and shaded in vectors (shade_batch.h); what is rare is shaded one by one by the steps of
// whitted.cpp. The picture is the same to the bit as by recursion.

#include "render/shade_batch.h"
#include "render/whitted.h"

#include <algorithm>

namespace glint {

namespace {

vec3 at(const Flights::Vectors& rows, std::size_t i) { return {rows[0][i], rows[1][i], rows[2][i]}; }

void put(const vec3& v, Flights::Vectors& rows, std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) rows[static_cast<std::size_t>(axis)][i] = v[axis];
}

template <class T>
std::span<T> part(Flights::Row<T>& row, Level level) {
    return {row.data() + level.first, level.count};
}

SurfaceRows surface_rows(Flights& f, std::size_t first) {
    SurfaceRows rows{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        rows.p[axis] = f.p[axis].data() + first;
        rows.p_error[axis] = f.p_error[axis].data() + first;
        rows.n[axis] = f.n[axis].data() + first;
    }
    return rows;
}

} // namespace

void WhittedTracer::estimate(std::span<const CameraSample> samples, std::span<Channels> out, bool terms) {
    while (samples.size() > Flights::most) {
        estimate(samples.first(Flights::most), out.first(Flights::most), terms);
        samples = samples.subspan(Flights::most);
        out = out.subspan(Flights::most);
    }
    if (kernel_.kernel == Kernel::scalar) return estimate_alone(samples, out);
    arena_.clear();
    record_ = nullptr;
    if (flights_ == nullptr) flights_ = std::make_unique<Flights>();
    start(samples);
    levels_.clear();
    for (Level level{0, samples.size()}; level.count > 0;) {
        if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return;
        levels_.push_back(level);
        find_hits(level);
        for (const LightRecord& light : scene_.lights) add_light(light, level);
        shade_->limit_terms(modes_, level, *flights_);
        level = grow(level, static_cast<int>(levels_.size()) - 1);
    }
    gather();
    finish(out, terms);
}

void WhittedTracer::estimate_alone(std::span<const CameraSample> samples, std::span<Channels> out) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        out[i].terms = trace(samples[i].origin, samples[i].direction, nullptr, &out[i].covered);
        out[i].radiance = out[i].terms.sum();
    }
}

void WhittedTracer::start(std::span<const CameraSample> samples) {
    Path path;
    start_primary(vec3(0.0f), vec3(0.0f), path);
    counts_.primary += samples.size() - 1;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        flights_->rays[i] = Ray{};
        flights_->rays[i].origin = samples[i].origin;
        flights_->rays[i].direction = samples[i].direction;
        flights_->media[i] = path.media;
    }
}

void WhittedTracer::finish(std::span<Channels> out, bool terms) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i].radiance = at(flights_->sums, i);
        out[i].covered = static_cast<bool>(flights_->hits[i]);
        if (terms) out[i].terms = terms_of(i);
    }
}

void WhittedTracer::find_hits(Level level) {
    Flights& f = *flights_;
    const std::span<Hit> hits = part(f.hits, level);
    scene_.world.closest(part(f.rays, level), hits, RayHint::coherent, scratch_, kernel_);
    if (scene_.any_transparent)
        for (std::size_t i = level.first; i < level.first + level.count; ++i)
            if (f.media[i] != nullptr) pass_hidden(f.rays[i], f.hits[i], f.media[i]);
    choose_materials(level);
    const std::span<std::uint8_t> done = part(f.blocked, level);
    scene_.world.surfaces(part(f.rays, level), hits, surface_rows(f, level.first), done, kernel_);
    shade_->set_up(scene_, level, f);
    for (std::size_t i = level.first; i < level.first + level.count; ++i)
        if (f.hits[i] && (f.blocked[i] == 0 || is_special(f.hits[i].object))) set_up_alone(i);
    shade_->start_terms(scene_, level, f);
}

/// Nothing, as a material, is what is seen there.
void WhittedTracer::choose_materials(Level level) {
    Flights& f = *flights_;
    const FrozenObject* objects = scene_.objects.data();
    const MaterialRecord* materials = scene_.materials.data();
    for (std::size_t i = level.first; i < level.first + level.count; ++i) {
        const MaterialRecord* nothing = f.media[i] == nullptr ? &background_ : &darkness_;
        f.materials[i] = f.hits[i] ? &materials[objects[f.hits[i].object].material] : nothing;
    }
    std::fill(&f.materials[level.first + level.count], f.materials.data() + level.end(), &darkness_);
}

/// Is more to be known of its surfaces than planes and spheres tell?
bool WhittedTracer::is_special(std::uint32_t object) const {
    return scene_.objects[object].attributes != no_attributes || scene_.objects[object].lit_as_stored;
}

void WhittedTracer::set_up_alone(std::size_t i) {
    Flights& f = *flights_;
    const Surface s = surface_at(f.rays[i], f.hits[i]);
    put(s.point.p, f.p, i);
    put(s.point.p_error, f.p_error, i);
    put(s.n_g, f.n_g, i);
    put(s.n, f.n, i);
    put(s.color, f.color, i);
    f.entering[i] = s.entering ? 1.0f : 0.0f;
    f.lit_side[i] = s.lit_side;
}

/// Adds one light to all flights that it can reach.
void WhittedTracer::add_light(const LightRecord& light, Level level) {
    Flights& f = *flights_;
    const std::size_t count = shade_->aim(light, level, f);
    if (count == 0) return;
    counts_.shadow += count;
    scene_.world.occluded(part(f.shadow_rays, level), part(f.blocked, level), RayHint::coherent, scratch_,
                          kernel_);
    // Only some of a scene with glass: media and light from behind tell whether there is a need to walk.
    const bool transmissive = settings_.shadows == Shadows::transmissive;
    if (scene_.any_transparent)
        for (std::size_t i = level.first; i < level.first + level.count; ++i) {
            const bool walk = transmissive || f.media[i] != nullptr || f.lit_side[i] < 0.0f;
            f.through[i] = f.blocked[i] != 0 && walk
                               ? behind_blockers(f.shadow_rays[i], surface_of(i), f.media[i])
                               : 0.0f;
        }
    shade_->add_light(modes_, level, f);
}

/// Launches the branches of a level: the next level.
Level WhittedTracer::grow(Level level, int depth) {
    Level next{level.end(), 0};
    if (depth >= settings_.max_depth) return next;
    const std::size_t most = level.count * (scene_.any_transparent ? 2 : 1);
    if (next.first + most > Flights::most) {
        for (std::size_t i = level.first; i < level.first + level.count; ++i) branch_alone(i, depth);
        return next;
    }
    next.count = shade_->reflect(modes_, level, next.first, *flights_);
    counts_.reflected += next.count;
    if (scene_.any_transparent)
        for (std::size_t i = level.first; i < level.first + level.count; ++i)
            if (flights_->transparency[i] > 0.0f) cross_alone(i, depth, next);
    return next;
}

/// Launches the branches of what light goes through.
void WhittedTracer::cross_alone(std::size_t i, int depth, Level& next) {
    const Path path = path_of(i, depth);
    const Surface surface = surface_of(i);
    Terms terms = terms_of(i);
    const Split split = split_at(path, surface, terms, -1);
    put_terms(terms, i);
    Path branch;
    if (split.reflected > 0.0f) {
        reflect(path, surface, -1, branch);
        launch(branch, i, Term::reflection, split.reflected, next);
    }
    if (split.refracted > 0.0f) {
        transmit(path, surface, split, -1, branch);
        launch(branch, i, Term::transmission, split.refracted, next);
    }
}

void WhittedTracer::launch(const Path& path, std::size_t parent, Term term, float weight, Level& next) {
    Flights& f = *flights_;
    const std::size_t i = next.first + next.count++;
    f.rays[i] = Ray{};
    f.rays[i].origin = path.origin;
    f.rays[i].direction = path.direction;
    f.media[i] = path.media;
    f.parents[i] = static_cast<std::uint32_t>(parent);
    f.branches[i] = term;
    f.weights[i] = weight;
}

/// Follows the branches by recursion.
void WhittedTracer::branch_alone(std::size_t i, int depth) {
    const Path path = path_of(i, depth);
    const Surface surface = surface_of(i);
    if (!flights_->hits[i] || !goes_on(path, surface, -1)) return;
    Terms terms = terms_of(i);
    branch(path, surface, terms, -1);
    put_terms(terms, i);
}

WhittedTracer::Path WhittedTracer::path_of(std::size_t i, int depth) const {
    Path path;
    path.origin = flights_->rays[i].origin;
    path.direction = flights_->rays[i].direction;
    path.media = flights_->media[i];
    path.depth = depth;
    return path;
}

WhittedTracer::Surface WhittedTracer::surface_of(std::size_t i) const {
    const Flights& f = *flights_;
    Surface s;
    s.point.p = at(f.p, i);
    s.point.p_error = at(f.p_error, i);
    s.material = f.materials[i];
    s.object = f.hits[i].object;
    s.v = at(f.v, i);
    s.n_g = at(f.n_g, i);
    s.n = at(f.n, i);
    s.lit_side = f.lit_side[i];
    s.color = at(f.color, i);
    s.entering = f.entering[i] != 0.0f;
    return s;
}

Terms WhittedTracer::terms_of(std::size_t i) const {
    Terms terms;
    for (std::size_t t = 0; t < term_count; ++t) terms.value[t] = at(flights_->terms[t], i);
    return terms;
}

void WhittedTracer::put_terms(const Terms& terms, std::size_t i) {
    for (std::size_t t = 0; t < term_count; ++t) put(terms.value[t], flights_->terms[t], i);
}

/// What branches bring, the youngest first.
void WhittedTracer::gather() {
    Flights& f = *flights_;
    for (std::size_t n = levels_.size(); n-- > 0;) {
        const Level level = levels_[n];
        for (std::size_t i = level.first; scene_.any_transparent && i < level.first + level.count; ++i) {
            if (f.media[i] == nullptr || !f.hits[i]) continue;
            Terms terms = terms_of(i);
            absorb(f.media[i], f.hits[i].t, terms, -1);
            put_terms(terms, i);
        }
        shade_->sum_terms(level, f);
        if (n > 0) shade_->bring(level, f);
    }
}

} // namespace glint
