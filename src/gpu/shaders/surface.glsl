// From a hit back to the surface: what the functions of geometry/surface.shared.h need is read from the buffers.

SurfacePoint triangle_point(Hit hit, vec3 direction, double u, double v) {
    vec3 a, b, c;
    leaf_triangle(hit.at, leaf_triangle_number(hit.at), a, b, c);
    bool reversed = object_is(hit.object, object_reversed);
#if GLINT_INSTANCES
    if (object_is(hit.object, object_instance)) {
        ObjectRecord object = objects[hit.object];
        dmat3 inverse = unpacked(object.inverse);
        return instance_surface(a, b, c, u, v, inverse * dvec3(direction), unpacked(object.linear), inverse,
                                unpacked(object.translation), object.slack, reversed);
    }
#endif
    return triangle_surface(a, b, c, u, v, dvec3(direction), reversed);
}

SurfacePoint quadric_point(Hit hit, dvec3 origin, dvec3 direction) {
    SolidSpan span;
    span_in_shape(hit.at, origin, direction, span);
    ShapeRecord shape = shapes[hit.at];
    to_shape(shape, origin, direction);
    bool leaves_it = hit.u != 0.0f;
    double t = leaves_it ? span.leave : span.enter;
    dvec3 p, n;
    point_of_quadric(quadric_of(shape), leaves_it ? span.leave_part : span.enter_part, origin + direction * t, p, n);
    double size = size_of_quadric(quadric_of(shape));
    if (shape.is_local == 0u) return rounded_point(p, n, surface_error * size);
    return point_in_world(p, n, unpacked(objects[shape.object].linear), unpacked(objects[shape.object].inverse),
                          unpacked(objects[shape.object].translation), size);
}

SurfacePoint surface_at(Hit hit, vec3 origin, vec3 direction) {
    if (hit.kind == kind_triangle) {
        SurfacePoint point = triangle_point(hit, direction, double(hit.u), double(hit.v));
        if (!hit.on_edge) return point;
        double third = double(1.0f / 3.0f);
        return moved_off_edge(point, triangle_point(hit, direction, third, third).p);
    }
    if (hit.kind == kind_plane)
        return plane_surface(dvec3(origin), dvec3(direction), unpacked(shapes[hit.at].axis), shapes[hit.at].height);
    return quadric_point(hit, dvec3(origin), dvec3(direction));
}

vec3 vertex_normal(uint object, uint vertex) {
    vec3 n = array_vector(objects[object].normals, vertex);
    if (!object_is(object, object_local_normals)) return n;
    return transformed_normal(unpacked(objects[object].normal_matrix), n);
}

/// Colour and shading normal from the mesh's vertices, where it has them.
void interpolate(Hit hit, inout SurfaceRecord s) {
    uint normals = objects[hit.object].normals;
    uint colors = objects[hit.object].colors;
    if (normals == invalid_index && colors == invalid_index) return;
    if (hit.kind != kind_triangle) {
        s.color = array_vector(colors, hit.prim);
        return;
    }
    uvec3 corner = array_corners(objects[hit.object].corners, hit.prim);
    if (colors != invalid_index)
        s.color = interpolated(array_vector(colors, corner.x), array_vector(colors, corner.y),
                               array_vector(colors, corner.z), hit.u, hit.v);
    if (normals == invalid_index) return;
    vec3 normal = interpolated(vertex_normal(hit.object, corner.x), vertex_normal(hit.object, corner.y),
                               vertex_normal(hit.object, corner.z), hit.u, hit.v);
    s.n = shading_normal(normal, s.n_g);
}
