// Rays against everything: one loop for the closest hit, for the next one and for any, one node or one shape
// a turn. The tree is that of gpu/tree.h; the tests are those of the CPU.

const uint kind_none = 0u;
const uint kind_triangle = 1u;
const uint kind_sphere = 2u;
const uint kind_cylinder = 3u;
const uint kind_plane = 4u;

struct Hit {
    float t;
    float u; // as in trace/world.h
    float v;
    uint kind;
    uint object;
    uint prim;
    uint at;       // of a triangle its leaf's code, its number there in place of their count; else the shape
    uint instance; // or `none`
    bool on_edge;
    bool positive;
};

Hit no_hit(float t) { return Hit(t, 0.0f, 0.0f, kind_none, none, 0u, 0u, none, false, false); }

/// trace/world.h: precedes().
bool precedes(Hit a, Hit b) {
    if (a.t != b.t) return a.t < b.t;
    if (a.object != b.object) return a.object < b.object;
    if (a.prim != b.prim) return a.prim < b.prim;
    return a.kind == b.kind && a.kind != kind_triangle && a.u < b.u;
}

/// The crossing that `earlier` stands for, met again in the neighbour across an edge.
bool same_crossing(Hit earlier, Hit later) {
    return earlier.on_edge && later.on_edge && earlier.object == later.object &&
           earlier.positive == later.positive && earlier.t >= later.t - abs(later.t) * (1.0f / 262144.0f);
}

bool follows(Hit previous, Hit hit) {
    return previous.kind == kind_none || (precedes(previous, hit) && !same_crossing(previous, hit));
}

float largest(vec3 v) { return max(max(v.x, v.y), v.z); }
double largest(dvec3 v) { return max(max(v.x, v.y), v.z); }

/// The axes in the order kx, ky, kz of geometry/triangle.h.
vec3 permuted(vec3 v, int kz) { return kz == 0 ? v.yzx : (kz == 1 ? v.zxy : v.xyz); }

/// A ray in the space it is in, as boxes and triangles want it.
struct SpaceRay {
    vec3 origin;
    vec3 inverse; // bvh/traverse.h: BoxRay
    float pad;
    uint octant; // bit by axis: the direction is negative
    int kz;
    vec3 sheared_origin;
    vec3 shear; // d[kx]/d[kz], d[ky]/d[kz], 1/d[kz]
};

/// 2^-20 is what boxes must grow by, in |coordinates|.
SpaceRay space_ray(vec3 origin, vec3 direction, float corner, float slack) {
    SpaceRay ray;
    vec3 size = abs(direction);
    float least = max(1e-18f * largest(size), 2.95e-39f);
    bvec3 negative = lessThan(direction, vec3(0.0f));
    ray.origin = origin;
    ray.inverse = mix(vec3(1.0f), vec3(-1.0f), negative) / max(size, vec3(least));
    float reach = largest(abs(origin));
    ray.pad = (reach + corner) * (1.0f / 1048576.0f) + reach * slack;
    ray.octant = uint(negative.x) | uint(negative.y) << 1 | uint(negative.z) << 2;
    ray.kz = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    vec3 d = permuted(direction, ray.kz);
    ray.sheared_origin = permuted(origin, ray.kz);
    ray.shear = vec3(d.x / d.z, d.y / d.z, 1.0f / d.z);
    return ray;
}

vec4 bytes_of(uint word) { return vec4((uvec4(word) >> uvec4(0u, 8u, 16u, 24u)) & 255u); }

/// Where the ray enters (x) and leaves (y) four children along one axis.
void clip_axis(uint low, uint high, bool negative, float base, float scale, float pad, float inverse,
               inout vec4 enter, inout vec4 leave) {
    vec4 near = bytes_of(negative ? high : low) * scale + base;
    vec4 far = bytes_of(negative ? low : high) * scale + base;
    float outward = negative ? pad : -pad;
    enter = max(enter, (near + outward) * inverse);
    leave = min(leave, (far - outward) * inverse);
}

/// The children that the ray meets in [from, to], as bits in the order in which it should enter them.
uint children_met(uint node, SpaceRay ray, float from, float to) {
    uvec4 head = nodes[6u * node];
    vec3 base = uintBitsToFloat(head.xyz) - ray.origin;
    vec3 scale = intBitsToFloat(ivec3((head.www >> uvec3(0u, 8u, 16u)) & 255u) << 23);
    bvec3 negative = bvec3((uvec3(ray.octant) >> uvec3(0u, 1u, 2u)) & 1u);
    uvec4 qx = nodes[6u * node + 3u];
    uvec4 qy = nodes[6u * node + 4u];
    uvec4 qz = nodes[6u * node + 5u];
    uint met = 0u;
    for (uint half_node = 0u; half_node < 2u; ++half_node) {
        vec4 enter = vec4(from);
        vec4 leave = vec4(to);
        bool first = half_node == 0u;
        clip_axis(first ? qx.x : qx.y, first ? qx.z : qx.w, negative.x, base.x, scale.x, ray.pad,
                  ray.inverse.x, enter, leave);
        clip_axis(first ? qy.x : qy.y, first ? qy.z : qy.w, negative.y, base.y, scale.y, ray.pad,
                  ray.inverse.y, enter, leave);
        clip_axis(first ? qz.x : qz.y, first ? qz.z : qz.w, negative.z, base.z, scale.z, ray.pad,
                  ray.inverse.z, enter, leave);
        uvec4 inside = uvec4(lessThanEqual(enter, leave)) & ((uvec4(head.w) >> (24u + 4u * half_node + uvec4(0u, 1u, 2u, 3u))) & 1u);
        uvec4 place = (uvec4(0u, 1u, 2u, 3u) + 4u * half_node) ^ ray.octant;
        uvec4 bits = inside << place;
        met |= bits.x | bits.y | bits.z | bits.w;
    }
    return met;
}

vec3 leaf_vertex(uint word, uint count, uint number) {
    uint at = word + 4u + number;
    return uintBitsToFloat(uvec3(leaves[at], leaves[at + count], leaves[at + 2u * count]));
}

/// The corners of triangle i of a leaf.
void leaf_triangle(uint code, uint i, out vec3 a, out vec3 b, out vec3 c) {
    uint word = (code & 0x01ffffffu) * 4u;
    uint count = ((code >> 25) & 7u) + 1u;
    uint corners = leaves[word + i / 2u] >> (16u * (i % 2u));
    a = leaf_vertex(word, count, corners & 7u);
    b = leaf_vertex(word, count, (corners >> 3) & 7u);
    c = leaf_vertex(word, count, (corners >> 6) & 7u);
}

ShearedVertex sheared(SpaceRay ray, vec3 vertex) {
    precise vec3 v = permuted(vertex, ray.kz) - ray.sheared_origin;
    precise float x = v.x - ray.shear.x * v.z;
    precise float y = v.y - ray.shear.y * v.z;
    return ShearedVertex(x, y, v.z);
}

/// Object and number within it of the triangle with a running number.
void name_triangle(uint number, uint instance, out uint object, out uint prim) {
    if (instance != none) {
        object = uint(shapes[settings.first_instance + 26u * instance + 22u]);
        prim = number;
        return;
    }
    uint low = 0u;
    uint high = settings.mesh_count;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (words[2u * middle] <= number)
            low = middle;
        else
            high = middle;
    }
    object = words[2u * low + 1u];
    prim = number - words[2u * low];
}

bool test_triangle(SpaceRay ray, uint code, uint i, uint instance, float limit, inout Hit hit) {
    vec3 a, b, c;
    leaf_triangle(code, i, a, b, c);
    ShearedVertex sa = sheared(ray, a);
    ShearedVertex sb = sheared(ray, b);
    ShearedVertex sc = sheared(ray, c);
    if (surely_outside(sa, sb, sc)) return false;
    TriangleHit found;
    if (!intersect_sheared(sa, sb, sc, ray.shear.z, 0.0f, limit, found)) return false;
    hit = Hit(found.t, found.u, found.v, kind_triangle, 0u, 0u, (code & 0x8fffffffu) | i << 28, instance,
              found.on_edge, found.positive);
    uint word = (code & 0x01ffffffu) * 4u;
    uint count = ((code >> 25) & 7u) + 1u;
    name_triangle(leaves[word + 4u + 3u * count + i], instance, hit.object, hit.prim);
    return true;
}

/// The span of a line in a quadric, in the quadric's own space.
bool span_in_quadric(uint quadric, dvec3 origin, dvec3 direction, out SolidSpan span) {
    uint at = settings.first_quadric + 12u * quadric;
    double affine = shapes[at + 1u];
    if (affine >= 0.0) {
        uint place = settings.first_affine + 21u * uint(affine);
        dmat3 inverse = shape_matrix(place + 9u);
        origin = inverse * (origin - shape_vector(place + 18u));
        direction = inverse * direction;
    }
    dvec3 from = origin - shape_vector(at + 4u);
    span.enter_part = 0;
    span.leave_part = 0;
    if (shapes[at] == double(kind_cylinder))
        return line_in_cylinder(from, direction, shape_vector(at + 7u), shapes[at + 10u], shapes[at + 11u], span);
    return line_in_ball(from, direction, shapes[at + 11u], span.enter, span.leave);
}

/// The first of a quadric's two hits that follows another.
bool test_quadric(uint quadric, dvec3 origin, dvec3 direction, Hit after, float limit, inout Hit hit) {
    SolidSpan span;
    if (!span_in_quadric(quadric, origin, direction, span)) return false;
    uint at = settings.first_quadric + 12u * quadric;
    hit = Hit(float(span.enter), 0.0f, 0.0f, uint(shapes[at]), uint(shapes[at + 2u]), uint(shapes[at + 3u]),
              quadric, none, false, false);
    if (!(span.enter > 0.0) || !follows(after, hit)) {
        if (!(span.leave > 0.0)) return false;
        hit.t = float(span.leave);
        hit.u = 1.0f;
    }
    return hit.t <= limit;
}

bool test_plane(uint plane, dvec3 origin, dvec3 direction, float limit, inout Hit hit) {
    double t;
    if (!line_meets_plane(origin, direction, shape_vector(5u * plane), shapes[5u * plane + 3u], t)) return false;
    hit = Hit(float(t), 0.0f, 0.0f, kind_plane, uint(shapes[5u * plane + 4u]), 0u, plane, none, false, false);
    return t > 0.0 && hit.t <= limit;
}

/// The ray in the space of an instance's mesh, rounded once.
void to_instance(uint instance, vec3 origin, vec3 direction, out vec3 local_origin, out vec3 local_direction) {
    uint at = settings.first_instance + 26u * instance;
    dmat3 inverse = shape_matrix(at);
    local_origin = vec3(inverse * (dvec3(origin) - shape_vector(at + 9u)));
    local_direction = vec3(inverse * dvec3(direction));
}

/// Finite, and with a direction.
bool traceable(vec3 origin, vec3 direction) {
    vec3 zero = origin * 0.0f + direction * 0.0f;
    return zero == vec3(0.0f) && direction != vec3(0.0f);
}

const uint leave_instance = 0xffffffffu;

// Turns of all walks so far.
uint turns = 0u;

#if GLINT_COUNT
// What the last trace() did: nodes whose children's boxes it tested, and shapes that it tested.
uint steps_to_nodes = 0u;
uint steps_to_shapes = 0u;
#endif

/// The least hit with 0 < t <= limit that follows `after`; with `any` the first that is found.
Hit trace(vec3 origin, vec3 direction, float limit, Hit after, bool any) {
    Hit best = no_hit(limit);
#if GLINT_COUNT
    steps_to_nodes = 0u;
    steps_to_shapes = 0u;
#endif
    if (!traceable(origin, direction)) return best;
    SpaceRay ray = space_ray(origin, direction, settings.max_coordinate, settings.instance_slack);
    float from = max(after.t, 0.0f);
    uint stack[GLINT_STACK];
    int waiting = 0;
    uint instance = none;
    uint node = 0u;
    uint met = 0u;                     // children of `node` that are still to be entered
    uint next = settings.tree_root;  // the node to visit now, or none
    uint left = settings.plane_count;     // shapes of the leaf that are still to be tested
    uint leaf = kind_plane;            // their kind
    uint leaf_at = 0u;
    for (;;) {
        ++turns;
        if (left == 0u) {
            if (next == none) {
                if (met == 0u) {
                    if (waiting == 0) break;
                    uint entry = stack[--waiting];
                    if (entry == leave_instance) {
                        instance = none;
                        ray = space_ray(origin, direction, settings.max_coordinate, settings.instance_slack);
                        continue;
                    }
                    node = entry >> 8;
                    met = entry & 255u;
                }
                uint place = uint(findLSB(met));
                met &= met - 1u;
                uint slot = place ^ ray.octant;
                uint code = nodes[6u * node + 1u + slot / 4u][slot % 4u];
                if (code >> 31 != 0u) {
                    leaf = kind_triangle;
                    leaf_at = code;
                    left = ((code >> 28) & 7u) + 1u;
                } else if (code >> 30 == 0u) {
                    if (met != 0u) stack[waiting++] = node << 8 | met;
                    next = code;
#if GLINT_INSTANCES
                } else if (code >> 29 == 3u) {
                    if (met != 0u) stack[waiting++] = node << 8 | met;
                    stack[waiting++] = leave_instance;
                    met = 0u;
                    instance = code & 0x1fffffffu;
                    vec3 local_origin, local_direction;
                    to_instance(instance, origin, direction, local_origin, local_direction);
                    uint at = settings.first_instance + 26u * instance;
                    ray = space_ray(local_origin, local_direction, float(shapes[at + 25u]), 0.0f);
                    if (traceable(local_origin, local_direction)) next = uint(shapes[at + 24u]);
#endif
                } else {
                    leaf = kind_sphere;
                    leaf_at = code & 0x00ffffffu;
                    left = ((code >> 24) & 31u) + 1u;
                }
            }
            if (next != none) {
                node = next;
                next = none;
                met = children_met(node, ray, from, best.t);
#if GLINT_COUNT
                ++steps_to_nodes;
#endif
            }
        }
        if (left > 0u) {
            --left;
#if GLINT_COUNT
            ++steps_to_shapes;
#endif
            Hit hit;
            bool found;
            if (leaf == kind_triangle)
                found = test_triangle(ray, leaf_at, left, instance, best.t, hit);
            else if (leaf == kind_plane)
                found = test_plane(leaf_at + left, dvec3(origin), dvec3(direction), best.t, hit);
            else
                found = test_quadric(leaf_at + left, dvec3(origin), dvec3(direction), after, best.t, hit);
            if (found && follows(after, hit) && (best.kind == kind_none || precedes(hit, best))) {
                best = hit;
                if (any) break;
            }
        }
    }
    return best;
}
