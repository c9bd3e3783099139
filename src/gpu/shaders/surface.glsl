// From a hit back to the surface (trace/world_surface.cpp): exact in double, rounded once.

struct Surface {
    vec3 p;
    vec3 p_error; // absolute bound, per axis
    vec3 n;       // unit geometric normal as the object has it
};

Surface rounded(dvec3 p, dvec3 n, double slack) {
    Surface surface;
    surface.p = vec3(p);
    surface.p_error = abs(surface.p) * (1.0f / 16777216.0f) + vec3(float(slack));
    surface.n = vec3(n);
    return surface;
}

const double double_error = 1.0 / 35184372088832.0; // 2^-45

Surface triangle_surface(Hit hit, vec3 direction, double u, double v) {
    vec3 a, b, c;
    leaf_triangle(hit.at, (hit.at >> 28) & 7u, a, b, c);
    dvec3 p, n;
#if GLINT_INSTANCES
    if (hit.instance != none) {
        uint at = settings.first_instance + 26u * hit.instance;
        dmat3 inverse = shape_matrix(at);
        point_of_triangle(a, b, c, u, v, inverse * dvec3(direction), p, n);
        dmat3 linear = shape_matrix(at + 12u);
        dvec3 there = dvec3(error_of_triangle(a, b, c, vec3(p))) * 1.25;
        dvec3 here = abs(linear[0]) * there.x + abs(linear[1]) * there.y + abs(linear[2]) * there.z;
        dvec3 normal = transpose(inverse) * n;
        normal = normal / sqrt(dot(normal, normal));
        Surface placed = rounded(linear * p + shape_vector(at + 9u), shapes[at + 23u] != 0.0 ? -normal : normal,
                                 shapes[at + 21u]);
        placed.p_error += vec3(here);
        return placed;
    }
#endif
    point_of_triangle(a, b, c, u, v, dvec3(direction), p, n);
    Surface surface;
    surface.p = vec3(p);
    surface.p_error = error_of_triangle(a, b, c, surface.p);
    surface.n = vec3(object_is(hit.object, object_turned) ? -n : n);
    return surface;
}

Surface quadric_surface(Hit hit, dvec3 origin, dvec3 direction) {
    SolidSpan span;
    span_in_quadric(hit.at, origin, direction, span);
    double t = hit.u != 0.0f ? span.leave : span.enter;
    int part = hit.u != 0.0f ? span.leave_part : span.enter_part;
    uint at = settings.first_quadric + 12u * hit.at;
    double affine = shapes[at + 1u];
    uint place = settings.first_affine + 21u * uint(max(affine, 0.0));
    dmat3 inverse = dmat3(1.0);
    if (affine >= 0.0) {
        inverse = shape_matrix(place + 9u);
        origin = inverse * (origin - shape_vector(place + 18u));
        direction = inverse * direction;
    }
    dvec3 base = shape_vector(at + 4u);
    double height = shapes[at + 10u];
    double radius = shapes[at + 11u];
    dvec3 p, n;
    if (hit.kind == kind_cylinder)
        point_of_cylinder(base, shape_vector(at + 7u), height, radius, part, origin + direction * t, p, n);
    else
        point_of_sphere(base, radius, origin + direction * t, p, n);
    double size = largest(abs(base)) + radius + height;
    if (affine < 0.0) return rounded(p, n, double_error * size);

    dmat3 linear = shape_matrix(place);
    dvec3 translation = shape_vector(place + 18u);
    dvec3 normal = transpose(inverse) * n;
    double stretch = largest(abs(linear[0])) + largest(abs(linear[1])) + largest(abs(linear[2]));
    return rounded(linear * p + translation, normal / sqrt(dot(normal, normal)),
                   double_error * (largest(abs(translation)) + stretch * size));
}

Surface plane_surface(Hit hit, dvec3 origin, dvec3 direction) {
    dvec3 normal = shape_vector(5u * hit.at);
    double offset = shapes[5u * hit.at + 3u];
    double t;
    line_meets_plane(origin, direction, normal, offset, t);
    dvec3 p = origin + direction * t;
    dvec3 on, n;
    point_of_plane(normal, offset, p, on, n);
    return rounded(on, n, double_error * (largest(abs(origin)) + largest(abs(p))));
}

Surface surface_of(Hit hit, vec3 origin, vec3 direction) {
    if (hit.kind == kind_triangle) return triangle_surface(hit, direction, double(hit.u), double(hit.v));
    if (hit.kind == kind_plane) return plane_surface(hit, dvec3(origin), dvec3(direction));
    return quadric_surface(hit, dvec3(origin), dvec3(direction));
}

/// A point exactly on an edge moves into its own face (render/whitted.cpp: step_off_edge).
void step_off_edge(Hit hit, vec3 direction, inout Surface surface) {
    float third = 1.0f / 3.0f;
    vec3 inward = triangle_surface(hit, direction, double(third), double(third)).p - surface.p;
    float size = sqrt(dot(inward, inward));
    float reach = 8.0f * largest(surface.p_error);
    if (!(size > reach)) return;
    surface.p = surface.p + inward * (reach / size);
    surface.p_error = surface.p_error + abs(surface.p) * (1.0f / 16777216.0f);
}

vec3 corner_normal(uvec4 attributes, uint vertex) {
    vec3 n = word_vector(attributes.y + 3u * vertex);
    if (attributes.w == none) return n;
    dvec3 turned = shape_matrix(attributes.w) * dvec3(n);
    double squared = dot(turned, turned);
    return squared > 0.0 ? vec3(turned / sqrt(squared)) : vec3(0.0f);
}

/// Colour and shading normal from the mesh's vertices, where it has them.
void interpolate(Hit hit, vec3 n_g, inout vec3 color, inout vec3 n) {
    uvec4 attributes = object_attributes(hit.object);
    if (attributes.y == none && attributes.z == none) return;
    if (hit.kind == kind_sphere) {
        color = word_vector(attributes.z + 3u * hit.prim);
        return;
    }
    uint at = attributes.x + 3u * hit.prim;
    uvec3 corner = uvec3(words[at], words[at + 1u], words[at + 2u]);
    float w = 1.0f - hit.u - hit.v;
    if (attributes.z != none)
        color = word_vector(attributes.z + 3u * corner.x) * w + word_vector(attributes.z + 3u * corner.y) * hit.u +
                word_vector(attributes.z + 3u * corner.z) * hit.v;
    if (attributes.y == none) return;
    vec3 sum = corner_normal(attributes, corner.x) * w + corner_normal(attributes, corner.y) * hit.u +
               corner_normal(attributes, corner.z) * hit.v;
    float squared = dot(sum, sum);
    if (!(squared > 0.0f)) return;
    n = sum / sqrt(squared);
    if (dot(n, n_g) < 0.0f) n = -n;
}
