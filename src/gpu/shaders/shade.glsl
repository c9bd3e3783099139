// One hit and its light: the steps of render/whitted.cpp, on the equations of shading/.

/// A ray on its way, with the share of its light that reaches the pixel.
struct Path {
    vec3 origin;
    vec3 direction;
    vec3 weight;
    uint depth;
    uint term; // reflection or transmission below the first hit, else `none`
    uvec4 media;
};

/// A hit, ready to be shaded.
struct Lit {
    vec3 p;
    vec3 p_error;
    vec3 v;   // to the viewer
    vec3 n_g; // geometric normal toward the viewer
    vec3 n;   // shading normal on its side
    vec3 color;
    float lit_side; // −1: lights find both normals turned away from the viewer
    uint object;
    bool entering;
};

/// What a light sends to a hit where nothing stands between.
struct Arriving {
    vec3 direction; // unit, to the light
    vec3 light;
};

Lit lit_surface(Hit hit, Surface surface, vec3 direction) {
    Lit s;
    if (hit.on_edge) step_off_edge(hit, direction, surface);
    s.p = surface.p;
    s.p_error = surface.p_error;
    s.object = hit.object;
    s.v = -direction;
    s.entering = dot(surface.n, direction) < 0.0f;
    s.n_g = s.entering ? surface.n : -surface.n;
    s.n = s.n_g;
    s.color = tables[4u * object_material(hit.object)].xyz;
    bool behind = s.entering == object_is(hit.object, object_turned);
    s.lit_side = object_is(hit.object, object_lit_as_stored) && behind ? -1.0f : 1.0f;
    interpolate(hit, s.n_g, s.color, s.n);
    return s;
}

Arriving arriving_from(Light light, Lit s) {
    Arriving a = Arriving(vec3(0.0f), vec3(0.0f));
    if (light.kind == light_directional) {
        a.direction = -light.direction;
        a.light = directional_light_arriving(light.strength,
                                             light_cosine(s.n * s.lit_side, s.n_g * s.lit_side, a.direction));
        return a;
    }
    LightArrival arrival =
        arrival_from_point(light.position, light.strength, s.p, s.n * s.lit_side, s.n_g * s.lit_side);
    if (!(arrival.distance > 0.0f)) return a;
    a.direction = arrival.direction;
    a.light = arrival.arriving;
    if (light.kind == light_spot)
        a.light = a.light * spot_falloff(-dot(a.direction, light.direction), light.cos_outer, light.cos_inner);
    return a;
}

/// Adds what gets through to a hit's diffuse and highlight terms.
void add_light(Lit s, Material m, Arriving a, float shadow, inout vec3 diffuse, inout vec3 highlight) {
    if (!(shadow > 0.0f)) return;
    vec3 lit = diffuse_term(a.light, s.color, m.diffuse) * shadow;
    if (settings.clamp_light != 0u) lit = limit_to_one(lit);
    diffuse = diffuse + lit;
    if (!(m.highlight > 0.0f)) return;
    float lobe = settings.phong_highlights == 0u ? blinn_lobe(s.n * s.lit_side, a.direction, s.v, m.shininess)
                                        : phong_lobe(s.n * s.lit_side, a.direction, s.v, m.shininess);
    highlight = highlight + highlight_term(a.light, m.highlight, lobe) * shadow;
}

/// How the light is shared between the two branches of a bounce.
struct Split {
    float reflected;
    float refracted;
    vec3 direction; // of the refracted branch
    uvec4 media;
    bool total;
};

/// False if the refracted direction would not go below the surface: then the geometric normal must serve.
bool refract_at(Lit s, Material m, vec3 n, float before, float after, inout Split split) {
    float cosine = dot(n, s.v);
    if (!(cosine > 0.0f) && n != s.n_g) return false;
    float eta = before / after;
    float discriminant = snell_discriminant(cosine, eta);
    split.total = discriminant < 0.0f;
    if (split.total) return false;
    split.direction = refracted_direction(s.v, n, eta, discriminant);
    if (!(dot(split.direction, s.n_g) < 0.0f) && n != s.n_g) return false;
    if (object_is(s.object, object_fresnel)) {
        float kept = m.reflectivity + m.transparency;
        float share = fresnel_reflectance(cosine, sqrt(discriminant), before, after);
        split.reflected = kept * share;
        split.refracted = kept * (1.0f - share);
    }
    return true;
}

Split split_at(Path path, Lit s, Material m) {
    Split split = Split(m.reflectivity, m.transparency, path.direction, path.media, false);
    uint medium = object_medium(s.object);
    if (medium == 0u) return split; // opaque, or a thin pane: straight on
    split.media = media_across(path.media, medium, s.entering);
    float before = media_index(path.media);
    float after = media_index(split.media);
    if (!refract_at(s, m, s.n, before, after, split) && !split.total)
        refract_at(s, m, s.n_g, before, after, split);
    if (split.total) {
        split.reflected = m.reflectivity + m.transparency;
        split.refracted = 0.0f;
    }
    return split;
}

Path reflected_path(Path path, Lit s, float share) {
    Path next = path;
    next.direction = mirror_ray_direction(s.v, s.n, s.n_g);
    next.origin = offset_ray_origin(s.p, s.p_error, s.n_g, next.direction);
    next.weight = path.weight * share;
    next.depth = path.depth + 1u;
    if (path.term == none) next.term = term_reflection;
    return next;
}

Path transmitted_path(Path path, Lit s, Split split) {
    Path next = path;
    next.direction = split.direction;
    next.origin = offset_ray_origin(s.p, s.p_error, s.n_g, next.direction);
    next.weight = path.weight * split.refracted;
    next.media = split.media;
    next.depth = path.depth + 1u;
    if (path.term == none) next.term = term_transmission;
    return next;
}
