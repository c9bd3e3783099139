#include "render/whitted.h"

#include "math/offset.shared.h"
#include "render/shade_batch.h"
#include "shading/whitted.shared.h"

#include <limits>

namespace glint {

WhittedTracer::WhittedTracer(const FrozenScene& scene, const WhittedSettings& settings,
                             const CancelFlag* cancel, const KernelChoice& kernel)
    : scene_(scene), settings_(settings), modes_(whitted_modes(settings)), cancel_(cancel), kernel_(kernel),
      shade_(&shade_kernels[row_of(kernel.target)]) {
    background_ = darkness_;
    background_.emission = scene.background;
}

void WhittedTracer::start_primary(const vec3& origin, const vec3& direction, Path& path) {
    path = Path{};
    path.origin = origin;
    path.direction = direction;
    for (const std::uint32_t object : scene_.camera_media)
        path.media = with(path.media, object, scene_, arena_);
    ++counts_.primary;
}

Terms WhittedTracer::trace(const vec3& origin, const vec3& direction, RayTree* record, bool* covered) {
    arena_.clear();
    record_ = record;
    if (record_ != nullptr) record_->nodes.clear();
    Path path;
    start_primary(origin, direction, path);
    return follow(path, covered);
}

Terms WhittedTracer::follow(Path path, bool* covered) {
    // A tree can have 2^max_depth rays: the wish to stop must reach into it.
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return Terms{};
    const int node = start_node(path);
    Ray ray;
    ray.origin = path.origin;
    ray.direction = path.direction;
    Hit hit = scene_.world.closest(ray, kernel_);
    pass_hidden(ray, hit, path.media, node);
    if (covered != nullptr) *covered = static_cast<bool>(hit);
    if (!hit) return missed(path, node);

    const Surface surface = surface_at(ray, hit);
    note_surface(path, hit, surface, node);
    Terms terms{};
    start_terms(surface, terms);
    light_surface(surface, path.media, terms, node);
    limit_terms(terms);
    if (goes_on(path, surface, node)) branch(path, surface, terms, node);
    absorb(path.media, hit.t, terms, node);
    note_terms(terms, node);
    return terms;
}

void WhittedTracer::light_surface(const Surface& surface, const Media* media, Terms& terms, int node) {
    for (std::uint32_t i = 0; i < scene_.lights.size(); ++i) {
        LightNode light;
        RayNode* record = node_at(node);
        ShadowNode* shadow = record != nullptr ? &record->shadows.emplace_back() : nullptr;
        if (reaches(i, surface, light)) {
            Ray ray;
            aim(surface, light, ray);
            if (shadow != nullptr) *shadow = {true, ray.origin, ray.direction, {}};
            if (scene_.world.occluded(ray, kernel_))
                light.shadow = behind_blockers(ray, surface, media, shadow);
            add_light(light, surface, terms);
        }
        if (record != nullptr) record->lights.push_back(light);
    }
}

void WhittedTracer::branch(const Path& path, const Surface& surface, Terms& terms, int node) {
    const Split split = split_at(path, surface, terms, node);
    Path next;
    if (split.reflected > 0.0f) {
        reflect(path, surface, node, next);
        terms[Term::reflection] = follow(next).sum() * split.reflected;
    }
    if (split.refracted > 0.0f) {
        transmit(path, surface, split, node, next);
        terms[Term::transmission] = follow(next).sum() * split.refracted;
    }
}

// Surfaces inside a transparent solid of higher rank are passed over on the same ray, one by one; `media`
// follows.
void WhittedTracer::pass_hidden(const Ray& ray, Hit& hit, const Media*& media, int node) {
    while (hit && hidden(media, hit.object, scene_)) {
        if (RayNode* record = node_at(node)) record->passed_over.push_back(hit);
        if (holds_media(hit.object)) media = across(media, hit.object, enters(ray, hit), scene_, arena_);
        hit = scene_.world.next(ray, hit);
    }
}

// What never leaves a solid brings nothing; what misses everything gets the background.
Terms WhittedTracer::missed(const Path& path, int node) const {
    Terms terms{};
    if (path.media == nullptr) terms[Term::emission] = scene_.background;
    if (RayNode* record = node_at(node)) {
        record->end = path.media == nullptr ? RayEnd::background : RayEnd::absorbed;
        note_media(path.media, *record);
    }
    note_terms(terms, node);
    return terms;
}

bool WhittedTracer::enters(const Ray& ray, const Hit& hit) const {
    return dot(scene_.world.surface(ray, hit).n, ray.direction) < 0.0f;
}

// Only what light goes through can be around a ray.
bool WhittedTracer::holds_media(std::uint32_t object) const {
    const FrozenObject& o = scene_.objects[object];
    return o.solid && scene_.materials[o.material].transparency > 0.0f;
}

WhittedTracer::Surface WhittedTracer::surface_at(const Ray& ray, const Hit& hit) const {
    Surface s{scene_.world.surface(ray, hit)};
    s.object = hit.object;
    s.material = &scene_.materials[scene_.objects[hit.object].material];
    if (hit.on_edge) step_off_edge(ray, hit, s.point);
    s.v = -ray.direction;
    s.entering = dot(s.point.n, ray.direction) < 0.0f;
    s.n_g = s.entering ? s.point.n : -s.point.n;
    s.n = s.n_g;
    s.color = s.material->color;
    const FrozenObject& object = scene_.objects[hit.object];
    if (object.lit_as_stored && s.entering == object.turned) s.lit_side = -1.0f;
    if (scene_.objects[hit.object].attributes != no_attributes) interpolate(hit, s);
    return s;
}

// A point exactly on an edge lies in two faces, and rays that start there must be on the right side of both:
// it moves into its own face, toward the middle, by a few times its error.
void WhittedTracer::step_off_edge(const Ray& ray, const Hit& hit, SurfacePoint& point) const {
    Hit middle = hit;
    middle.u = 1.0f / 3.0f;
    middle.v = 1.0f / 3.0f;
    point = moved_off_edge(point, scene_.world.surface(ray, middle).p);
}

void WhittedTracer::interpolate(const Hit& hit, Surface& s) const {
    const MeshAttributes& attributes =
        scene_.attributes[static_cast<std::size_t>(scene_.objects[hit.object].attributes)];
    if (hit.kind == PrimKind::quadric) {
        s.color = attributes.mesh->colors[hit.prim];
        return;
    }
    const uvec3 corner = attributes.mesh->triangles[hit.prim];
    if (attributes.colored) {
        const std::vector<vec3>& c = attributes.mesh->colors;
        s.color = interpolated(c[corner.x], c[corner.y], c[corner.z], hit.u, hit.v);
    }
    if (attributes.normals == nullptr) return;
    const std::int32_t matrix = scene_.objects[hit.object].normal_matrix;
    const auto normal = [&](std::uint32_t vertex) {
        const vec3& n = (*attributes.normals)[vertex];
        if (matrix == no_normal_matrix) return n;
        return transformed_normal(scene_.normal_matrices[static_cast<std::size_t>(matrix)], n);
    };
    s.n = shading_normal(interpolated(normal(corner.x), normal(corner.y), normal(corner.z), hit.u, hit.v),
                         s.n_g);
}

// ── Light that arrives from the lights
// ──────────────────────────────────────────────────────────────────────

void WhittedTracer::start_terms(const Surface& s, Terms& terms) const {
    terms = Terms{};
    terms[Term::ambient] = ambient_term(scene_.ambient, s.color, s.material->ambient);
    terms[Term::emission] = s.material->emission;
}

/// Sets what arrives from a light where nothing stands between; is it worth a shadow ray?
bool WhittedTracer::reaches(std::uint32_t index, const Surface& s, LightNode& node) const {
    node = LightNode{};
    node.light = index;
    arrive(scene_.lights[index], s, node);
    const bool shines = s.material->diffuse > 0.0f || s.material->highlight > 0.0f;
    return shines && node.arriving != vec3(0.0f);
}

void WhittedTracer::arrive(const LightRecord& light, const Surface& s, LightNode& node) const {
    if (light.kind == light_directional) {
        node.direction = -light.direction;
        node.distance = std::numeric_limits<float>::infinity();
        node.cosine = light_cosine(s.n * s.lit_side, s.n_g * s.lit_side, node.direction);
        node.arriving = directional_light_arriving(light.strength, node.cosine);
        return;
    }
    const LightArrival arrival =
        arrival_from_point(light.position, light.strength, s.point.p, s.n * s.lit_side, s.n_g * s.lit_side);
    node.direction = arrival.direction;
    node.distance = arrival.distance;
    node.cosine = arrival.cosine;
    node.arriving = arrival.arriving;
    if (light.kind == light_spot)
        node.arriving = node.arriving *
                        spot_falloff(-dot(node.direction, light.direction), light.cos_outer, light.cos_inner);
}

// The ray to the light ends at t = 1 for a light with a place, so that "between" needs no tolerance.
void WhittedTracer::aim(const Surface& s, const LightNode& light, Ray& ray) {
    ++counts_.shadow;
    const LightRecord& source = scene_.lights[light.light];
    ray = Ray{};
    ray.origin = offset_ray_origin(s.point.p, s.point.p_error, s.n_g, light.direction);
    ray.direction = light.direction;
    if (source.kind != light_directional) {
        ray.direction = source.position - ray.origin;
        ray.tmax = 1.0f;
    }
}

/// The share of the light that gets through what the ray meets.
float WhittedTracer::behind_blockers(const Ray& ray, const Surface& s, const Media* media,
                                     ShadowNode* record) {
    // Light on a back that is lit as stored arrives on the other side of the surface.
    if (s.lit_side < 0.0f && holds_media(s.object))
        media = across(media, s.object, s.entering, scene_, arena_);
    const bool walk =
        scene_.any_transparent && (settings_.shadows == Shadows::transmissive || media != nullptr);
    // Nothing gets through where there is no need to walk: then only the record wants to know what blocks.
    if (record != nullptr && !walk) walk_shadow(ray, media, record);
    return walk ? walk_shadow(ray, media, record) : 0.0f;
}

void WhittedTracer::add_light(LightNode& light, const Surface& s, Terms& terms) const {
    if (!(light.shadow > 0.0f)) return;
    const MaterialRecord& m = *s.material;
    light.diffuse = diffuse_term(light.arriving, s.color, m.diffuse) * light.shadow;
    if (settings_.clamp) light.diffuse = limit_to_one(light.diffuse);
    terms[Term::diffuse] = terms[Term::diffuse] + light.diffuse;
    if (!(m.highlight > 0.0f)) return;
    const float lobe = settings_.highlight_model == HighlightModel::blinn
                           ? blinn_lobe(s.n * s.lit_side, light.direction, s.v, m.shininess)
                           : phong_lobe(s.n * s.lit_side, light.direction, s.v, m.shininess);
    light.highlight = highlight_term(light.arriving, m.highlight, lobe) * light.shadow;
    terms[Term::highlight] = terms[Term::highlight] + light.highlight;
}

void WhittedTracer::limit_terms(Terms& terms) const {
    if (!settings_.clamp) return;
    terms[Term::ambient] = limit_to_range(terms[Term::ambient]);
    terms[Term::highlight] = limit_to_range(terms[Term::highlight]);
    const vec3 sum = (terms[Term::ambient] + terms[Term::diffuse]) + terms[Term::highlight];
    terms[Term::clamp] = limit_to_one(sum) - sum;
}

// Every visible crossing takes its share: τ only, no bending (docs/light-model.md, "Shadows").
// A record gets what stands behind the first opaque surface too.
float WhittedTracer::walk_shadow(const Ray& ray, const Media* media, ShadowNode* record) {
    crossings_.clear();
    scene_.world.crossings(ray, crossings_);
    float factor = 1.0f;
    for (const Hit& hit : crossings_) {
        const bool passed_over = hidden(media, hit.object, scene_);
        const float tau = scene_.materials[scene_.objects[hit.object].material].transparency;
        if (record != nullptr) record->blockers.push_back({hit.object, hit.t, tau, passed_over});
        if (!passed_over) {
            const bool opaque = settings_.shadows == Shadows::opaque || !(tau > 0.0f);
            if (opaque && record == nullptr) return 0.0f;
            factor = opaque ? 0.0f : factor * tau;
        }
        if (holds_media(hit.object)) media = across(media, hit.object, enters(ray, hit), scene_, arena_);
    }
    return factor;
}

// ── Light that arrives along mirror and refracted rays
// ──────────────────────────────────────────────────────

bool WhittedTracer::goes_on(const Path& path, const Surface& s, int node) const {
    const bool follows = s.material->reflectivity > 0.0f || s.material->transparency > 0.0f;
    if (follows && path.depth < settings_.max_depth) return true;
    if (RayNode* record = node_at(node)) record->end = follows ? RayEnd::depth_limit : RayEnd::matte;
    return false;
}

/// Weighs the local terms, and says what the branches will weigh.
WhittedTracer::Split WhittedTracer::split_at(const Path& path, const Surface& s, Terms& terms, int node) {
    const MaterialRecord& m = *s.material;
    const float local = local_weight(m.reflectivity, m.transparency, settings_.energy == Energy::balanced);
    for (const Term term : {Term::ambient, Term::diffuse, Term::highlight, Term::clamp})
        terms[term] = terms[term] * local;

    Split split;
    split.reflected = m.reflectivity;
    split.refracted = m.transparency;
    split.direction = path.direction;
    split.media = path.media;
    if (holds_media(s.object)) cross(path, s, split); // else opaque, or a thin pane: straight on
    if (RayNode* record = node_at(node)) {
        record->end = RayEnd::bounced;
        record->local_weight = local;
        record->reflected_weight = split.reflected;
        record->refracted_weight = split.refracted;
        record->index_before = split.index_before;
        record->index_after = split.index_after;
        record->total_reflection = split.total;
    }
    return split;
}

/// Through the surface of a solid: Snell's law, or all of the light back.
void WhittedTracer::cross(const Path& path, const Surface& s, Split& split) {
    split.media = across(path.media, s.object, s.entering, scene_, arena_);
    split.index_before = index_of(path.media, scene_);
    split.index_after = index_of(split.media, scene_);
    if (!refract(s, s.n, split) && !split.total) refract(s, s.n_g, split);
    if (split.total) {
        split.reflected = s.material->reflectivity + s.material->transparency;
        split.refracted = 0.0f;
    }
}

// False if the refracted direction would not go below the surface: then the geometric normal must serve.
bool WhittedTracer::refract(const Surface& s, const vec3& n, Split& split) const {
    const float cosine = dot(n, s.v);
    if (!(cosine > 0.0f) && n != s.n_g) return false;
    const float eta = split.index_before / split.index_after;
    const float discriminant = snell_discriminant(cosine, eta);
    split.total = discriminant < 0.0f;
    if (split.total) return false;
    split.direction = refracted_direction(s.v, n, eta, discriminant);
    if (!(dot(split.direction, s.n_g) < 0.0f) && n != s.n_g) return false;
    if ((s.material->flags & material_fresnel) != 0) {
        const float kept = s.material->reflectivity + s.material->transparency;
        const float share =
            fresnel_reflectance(cosine, sqrt(discriminant), split.index_before, split.index_after);
        split.reflected = kept * share;
        split.refracted = kept * (1.0f - share);
    }
    return true;
}

void WhittedTracer::reflect(const Path& path, const Surface& s, int node, Path& next) {
    ++counts_.reflected;
    next.direction = mirror_ray_direction(s.v, s.n, s.n_g);
    next.origin = offset_ray_origin(s.point.p, s.point.p_error, s.n_g, next.direction);
    next.media = path.media;
    next.depth = path.depth + 1;
    next.kind = RayKind::reflected;
    next.parent = node;
}

void WhittedTracer::transmit(const Path& path, const Surface& s, const Split& split, int node, Path& next) {
    ++counts_.refracted;
    next.direction = split.direction;
    next.origin = offset_ray_origin(s.point.p, s.point.p_error, s.n_g, next.direction);
    next.media = split.media;
    next.depth = path.depth + 1;
    next.kind = RayKind::refracted;
    next.parent = node;
}

void WhittedTracer::absorb(const Media* media, float distance, Terms& terms, int node) const {
    if (media == nullptr) return;
    const vec3 sigma = scene_.materials[scene_.objects[media->object].material].absorption;
    if (sigma == vec3(0.0f)) return;
    const vec3 left = transmittance(sigma, distance);
    for (vec3& value : terms.value) value = value * left;
    if (RayNode* record = node_at(node)) record->transmittance = left;
}

// ── The record
// ──────────────────────────────────────────────────────────────────────────────────────────────

int WhittedTracer::start_node(const Path& path) {
    if (record_ == nullptr) return -1;
    const int index = static_cast<int>(record_->nodes.size());
    RayNode node;
    node.kind = path.kind;
    node.parent = path.parent;
    node.depth = path.depth;
    node.origin = path.origin;
    node.direction = path.direction;
    record_->nodes.push_back(std::move(node));
    if (RayNode* parent = node_at(path.parent))
        (path.kind == RayKind::reflected ? parent->reflected : parent->refracted) = index;
    return index;
}

void WhittedTracer::note_surface(const Path& path, const Hit& hit, const Surface& surface, int node) const {
    RayNode* record = node_at(node);
    if (record == nullptr) return;
    record->hit = hit;
    record->position = surface.point.p;
    record->geometric_normal = surface.n_g;
    record->shading_normal = surface.n;
    record->color = surface.color;
    record->lit_side = surface.lit_side;
    record->entering = surface.entering;
    note_media(path.media, *record);
}

void WhittedTracer::note_media(const Media* media, RayNode& record) const {
    for (; media != nullptr; media = media->rest) record.media.push_back(media->object);
}

void WhittedTracer::note_terms(const Terms& terms, int node) const {
    RayNode* record = node_at(node);
    if (record == nullptr) return;
    record->terms = terms;
    record->radiance = terms.sum();
}

RayNode* WhittedTracer::node_at(int node) const {
    if (record_ == nullptr || node < 0) return nullptr;
    return &record_->nodes[static_cast<std::size_t>(node)];
}

} // namespace glint
