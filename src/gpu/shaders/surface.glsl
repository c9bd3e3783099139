// From a hit back to the surface: what the functions of geometry/surface.shared.h need is read from the buffers.

SurfacePoint triangle_point(Hit hit, dvec3 origin, dvec3 direction) {
    double u = double(hit.u);
    double v = double(hit.v);
    vec3 a, b, c;
    leaf_triangle(hit.at, leaf_triangle_number(hit.at), a, b, c);
    bool reversed = object_is(hit.object, object_reversed);
    double off_edges = objects[hit.object].off_edges;
    if (is_wide(hit.at))
        return wide_triangle_surface(a, b, c, origin + direction * double(hit.t), off_edges, direction,
                                     reversed);
    if (GLINT_INSTANCES == 0 || !object_is(hit.object, object_instance))
        return triangle_surface(a, b, c, u, v, off_edges, direction, reversed);
    ObjectRecord object = objects[hit.object];
    dmat3 inverse = unpacked(object.inverse);
    return instance_surface(a, b, c, u, v, off_edges, inverse * direction, unpacked(object.linear), inverse,
                            unpacked(object.translation), object.slack, reversed);
}

SurfacePoint quadric_point(Hit hit, dvec3 origin, dvec3 direction) {
    ShapeRecord shape = shapes[hit.at];
    QuadricShape quadric = quadric_of(shape);
    to_shape(shape, origin, direction);
    bool leaving = hit.u != 0.0f;
    if (shape.is_local == 0u) return quadric_surface(quadric, leaving, origin, direction);
    ObjectRecord object = objects[hit.object];
    return local_quadric_surface(quadric, leaving, origin, direction, unpacked(object.linear), unpacked(object.inverse),
                                 unpacked(object.translation));
}

SurfacePoint surface_at(Hit hit, vec3 origin, vec3 direction) {
    if (hit.kind == kind_triangle) return triangle_point(hit, dvec3(origin), dvec3(direction));
    if (hit.kind == kind_plane)
        return plane_surface(dvec3(origin), dvec3(direction), unpacked(shapes[hit.at].axis), shapes[hit.at].height);
    return quadric_point(hit, dvec3(origin), dvec3(direction));
}

/// Colour and shading normal from the mesh's vertices, where it has them. A sphere of a cloud has one colour.
void interpolate(Hit hit, inout SurfaceRecord s) {
    uint normals = objects[hit.object].normals;
    uint colors = objects[hit.object].colors;
    if (normals == invalid_index && colors == invalid_index) return;
    uvec3 corner = hit.kind == kind_triangle ? array_corners(objects[hit.object].corners, hit.prim) : uvec3(hit.prim);
    if (colors != invalid_index) s.color = interpolated(array_vectors(colors, corner), hit.u, hit.v);
    if (normals == invalid_index) return;
    mat3 n = array_vectors(normals, corner);
    if (object_is(hit.object, object_local_normals))
        n = transformed_normals(unpacked(objects[hit.object].normal_matrix), n);
    s.n = shading_normal(interpolated(n, hit.u, hit.v), s.n_g);
}
