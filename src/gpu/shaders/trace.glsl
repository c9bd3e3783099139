// Rays against everything: one loop for the closest hit, for the next one and for any; each iteration tests one node
// or one shape. The tree is that of gpu/tree.h; the tests are those of the CPU.

const uint kind_none = 0u;
const uint kind_triangle = 1u;
const uint kind_quadric = 2u;
const uint kind_plane = 3u;

struct Hit {
    float t;
    float u; // as in trace/world/world.h
    float v;
    uint kind;
    uint object;
    uint prim;
    uint at; // of a triangle its leaf's code, its number there in place of their count; else the shape
    bool on_edge;
    bool positive;
};

Hit no_hit(float t) { return Hit(t, 0.0f, 0.0f, kind_none, invalid_index, 0u, 0u, false, false); }

/// trace/world/world.h: precedes().
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

/// The axes in the order kx, ky, kz of geometry/triangle.h.
vec3 permuted(vec3 v, int kz) { return kz == 0 ? v.yzx : (kz == 1 ? v.zxy : v.xyz); }

/// A ray in the space that is traversed, prepared for tests of boxes and triangles.
struct SpaceRay {
    vec3 origin;
    vec3 inverse; // bvh/traverse.h: BoxRay
    float pad;
    uint octant; // bit by axis: the direction is negative
    int kz;
    vec3 sheared_origin;
    vec3 shear; // d[kx]/d[kz], d[ky]/d[kz], 1/d[kz]
};

/// Boxes grow by 2^-20 of the largest |coordinates|.
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
    uint head = nodes[node].exponents_and_mask;
    vec3 base = nodes[node].origin - ray.origin;
    vec3 scale = intBitsToFloat(ivec3((uvec3(head) >> uvec3(0u, 8u, 16u)) & 255u) << 23);
    bvec3 negative = bvec3((uvec3(ray.octant) >> uvec3(0u, 1u, 2u)) & 1u);
    uvec4 qx = nodes[node].sides_x;
    uvec4 qy = nodes[node].sides_y;
    uvec4 qz = nodes[node].sides_z;
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
        uvec4 child = uvec4(0u, 1u, 2u, 3u) + 4u * half_node;
        uvec4 inside = uvec4(lessThanEqual(enter, leave)) & ((uvec4(head) >> (24u + child)) & 1u);
        uvec4 bits = inside << (child ^ ray.octant);
        met |= bits.x | bits.y | bits.z | bits.w;
    }
    return met;
}

// A leaf's code (trace/mesh/tree.h, LeafCode); a hit has the triangle's number in place of the count.
uint leaf_word(uint code) { return (code & 0x01ffffffu) * 4u; }
uint leaf_vertices(uint code) { return ((code >> 25) & 7u) + 1u; }
uint leaf_triangles(uint code) { return ((code >> 28) & 7u) + 1u; }
uint leaf_triangle_number(uint hit_code) { return (hit_code >> 28) & 7u; }

vec3 leaf_vertex(uint word, uint count, uint number) {
    uint at = word + 4u + number;
    return uintBitsToFloat(uvec3(leaves[at], leaves[at + count], leaves[at + 2u * count]));
}

/// The corners of triangle i of a leaf.
void leaf_triangle(uint code, uint i, out vec3 a, out vec3 b, out vec3 c) {
    uint word = leaf_word(code);
    uint count = leaf_vertices(code);
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

/// Whether a leaf has wide triangles (geometry/triangle.h). Those are in the world's own space.
bool is_wide(uint code) { return (code & 0x01ffffffu) >= settings.first_wide_leaf; }

bool test_wide(SpaceRay ray, vec3 direction, vec3 a, vec3 b, vec3 c, float limit, out TriangleHit found) {
    dvec3 d = dvec3(permuted(direction, ray.kz));
    dvec3 shear = dvec3(d.x / d.z, d.y / d.z, 1.0 / d.z);
    dvec3 o = dvec3(ray.sheared_origin);
    return intersect_in_double(sheared_in_double(dvec3(permuted(a, ray.kz)) - o, shear),
                             sheared_in_double(dvec3(permuted(b, ray.kz)) - o, shear),
                             sheared_in_double(dvec3(permuted(c, ray.kz)) - o, shear), 0.0f, limit, found);
}

bool test_narrow(SpaceRay ray, vec3 a, vec3 b, vec3 c, float limit, out TriangleHit found) {
    ShearedVertex sa = sheared(ray, a);
    ShearedVertex sb = sheared(ray, b);
    ShearedVertex sc = sheared(ray, c);
    return !surely_outside(sa, sb, sc) && intersect_sheared(sa, sb, sc, ray.shear.z, 0.0f, limit, found);
}

/// The mesh in the world's own space that has the triangle with a running number.
uint mesh_of_triangle(uint number) {
    uint low = 0u;
    uint high = settings.mesh_count;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (mesh_first_triangle(middle) <= number)
            low = middle;
        else
            high = middle;
    }
    return low;
}

bool test_triangle(SpaceRay ray, vec3 direction, uint code, uint i, uint instance, float limit, inout Hit hit) {
    vec3 a, b, c;
    leaf_triangle(code, i, a, b, c);
    TriangleHit found;
    bool met = is_wide(code) ? test_wide(ray, direction, a, b, c, limit, found)
                             : test_narrow(ray, a, b, c, limit, found);
    if (!met) return false;
    uint number = leaves[leaf_word(code) + 4u + 3u * leaf_vertices(code) + i];
    hit = Hit(found.t, found.u, found.v, kind_triangle, instance, number, (code & 0x8fffffffu) | i << 28,
              found.on_edge, found.positive);
    if (instance == invalid_index) {
        uint mesh = mesh_of_triangle(number);
        hit.object = mesh_object(mesh);
        hit.prim = number - mesh_first_triangle(mesh);
    }
    return true;
}

QuadricShape quadric_of(ShapeRecord shape) {
    return QuadricShape(shape.kind, unpacked(shape.base), unpacked(shape.axis), shape.height, shape.radius);
}

/// The ray's line in the space of an object.
void to_local(uint object, inout dvec3 origin, inout dvec3 direction) {
    dmat3 inverse = unpacked(objects[object].inverse);
    origin = inverse * (origin - unpacked(objects[object].translation));
    direction = inverse * direction;
}

void to_shape(ShapeRecord shape, inout dvec3 origin, inout dvec3 direction) {
    if (shape.is_local != 0u) to_local(shape.object, origin, direction);
}

/// The part of a line inside a quadric, in the quadric's own space.
bool span_in_shape(uint shape_number, dvec3 origin, dvec3 direction, out SolidSpan span) {
    ShapeRecord shape = shapes[shape_number];
    to_shape(shape, origin, direction);
    return line_in_quadric(quadric_of(shape), origin, direction, span);
}

/// The first of a quadric's two hits that follows another.
bool test_quadric(uint shape, dvec3 origin, dvec3 direction, Hit after, float limit, inout Hit hit) {
    SolidSpan span;
    if (!span_in_shape(shape, origin, direction, span)) return false;
    hit = Hit(float(span.enter), 0.0f, 0.0f, kind_quadric, shapes[shape].object, shapes[shape].prim, shape, false,
              false);
    if (!(span.enter > 0.0) || !follows(after, hit)) {
        if (!(span.leave > 0.0)) return false;
        hit.t = float(span.leave);
        hit.u = 1.0f;
    }
    return hit.t <= limit;
}

bool test_plane(uint shape, dvec3 origin, dvec3 direction, float limit, inout Hit hit) {
    double t;
    if (!line_meets_plane(origin, direction, unpacked(shapes[shape].axis), shapes[shape].height, t)) return false;
    hit = Hit(float(t), 0.0f, 0.0f, kind_plane, shapes[shape].object, 0u, shape, false, false);
    return t > 0.0 && hit.t <= limit;
}

/// Finite, and with a direction.
bool traceable(vec3 origin, vec3 direction) {
    vec3 zero = origin * 0.0f + direction * 0.0f;
    return zero == vec3(0.0f) && direction != vec3(0.0f);
}

uint turns = 0u; // iterations of all traversals so far

#if GLINT_COUNT
// Of the last trace(): nodes whose children's boxes were tested, and shapes that were tested.
uint steps_to_nodes = 0u;
uint steps_to_shapes = 0u;
#endif

// Traversal is depth first. A stack entry is a node with those of its children that are still to be entered, as 24 and
// 8 bits, or leave_instance.
const uint leave_instance = 0xffffffffu;
uint walk_stack[GLINT_STACK];
int walk_waiting; // entries of the stack

struct Walk {
    vec3 origin;    // in the world
    vec3 direction;
    SpaceRay ray;   // in the space it is in
    uint instance;  // the object whose mesh it is in, or invalid_index
    uint node;
    uint children;  // of the node, still to be entered, as bits in their order
    uint next;      // the node to visit now, or invalid_index
    uint leaf_kind; // of the shapes that are tested now
    uint leaf;      // of triangles its code, else the first shape
    uint left;      // shapes that are still to be tested
};

/// Planes are in no tree: they are tested first.
Walk walk_of(vec3 origin, vec3 direction) {
    walk_waiting = 0;
    return Walk(origin, direction, space_ray(origin, direction, settings.max_coordinate, settings.instance_slack),
                invalid_index, 0u, 0u, settings.tree_root, kind_plane, 0u, settings.plane_count);
}

void push_children(Walk walk) {
    if (walk.children != 0u) walk_stack[walk_waiting++] = walk.node << 8 | walk.children;
}

void pop_children(inout Walk walk) {
    uint entry = walk_stack[--walk_waiting];
    if (entry == leave_instance) {
        walk.instance = invalid_index;
        walk.ray = space_ray(walk.origin, walk.direction, settings.max_coordinate, settings.instance_slack);
    } else {
        walk.node = entry >> 8;
        walk.children = entry & 255u;
    }
}

#if GLINT_INSTANCES
void enter_instance(inout Walk walk, uint object) {
    push_children(walk);
    walk_stack[walk_waiting++] = leave_instance;
    walk.children = 0u;
    walk.instance = object;
    dvec3 origin = dvec3(walk.origin);
    dvec3 direction = dvec3(walk.direction);
    to_local(object, origin, direction);
    walk.ray = space_ray(vec3(origin), vec3(direction), objects[object].mesh_max_coordinate, 0.0f);
    if (traceable(vec3(origin), vec3(direction))) walk.next = objects[object].mesh_root;
}
#endif

/// Goes to the next child of the node: a node, an instance or a leaf, by its code (gpu/tree.h).
void enter_child(inout Walk walk) {
    uint bit = uint(findLSB(walk.children));
    walk.children &= walk.children - 1u;
    uint code = nodes[walk.node].children[bit ^ walk.ray.octant];
    if (code >> 31 != 0u) {
        walk.leaf_kind = kind_triangle;
        walk.leaf = code;
        walk.left = leaf_triangles(code);
    } else if (code >> 30 == 0u) {
        push_children(walk);
        walk.next = code;
#if GLINT_INSTANCES
    } else if (code >> 29 == 3u) {
        enter_instance(walk, code & 0x1fffffffu);
#endif
    } else {
        walk.leaf_kind = kind_quadric;
        walk.leaf = settings.plane_count + (code & 0x00ffffffu);
        walk.left = ((code >> 24) & 31u) + 1u;
    }
}

void visit_node(inout Walk walk, float from, float to) {
    walk.node = walk.next;
    walk.next = invalid_index;
    walk.children = children_met(walk.node, walk.ray, from, to);
#if GLINT_COUNT
    ++steps_to_nodes;
#endif
}

/// The leaf's next shape, from its last to its first.
bool test_shape(inout Walk walk, Hit after, float limit, inout Hit hit) {
    --walk.left;
#if GLINT_COUNT
    ++steps_to_shapes;
#endif
    if (walk.leaf_kind == kind_triangle)
        return test_triangle(walk.ray, walk.direction, walk.leaf, walk.left, walk.instance, limit, hit);
    dvec3 origin = dvec3(walk.origin);
    dvec3 direction = dvec3(walk.direction);
    if (walk.leaf_kind == kind_plane) return test_plane(walk.left, origin, direction, limit, hit);
    return test_quadric(walk.leaf + walk.left, origin, direction, after, limit, hit);
}

/// The least hit with 0 < t <= limit that follows `after`; with `any` the first that is found.
Hit trace(vec3 origin, vec3 direction, float limit, Hit after, bool any) {
    Hit best = no_hit(limit);
#if GLINT_COUNT
    steps_to_nodes = 0u;
    steps_to_shapes = 0u;
#endif
    if (!traceable(origin, direction)) return best;
    Walk walk = walk_of(origin, direction);
    float from = max(after.t, 0.0f);
    for (;;) {
        ++turns;
        if (walk.left == 0u) {
            if (walk.next == invalid_index) {
                if (walk.children == 0u) {
                    if (walk_waiting == 0) break;
                    pop_children(walk);
                }
                if (walk.children != 0u) enter_child(walk);
            }
            if (walk.next != invalid_index) visit_node(walk, from, best.t);
        }
        Hit hit = best;
        if (walk.left > 0u && test_shape(walk, after, best.t, hit) && follows(after, hit) &&
            (best.kind == kind_none || precedes(hit, best))) {
            best = hit;
            if (any) break;
        }
    }
    return best;
}
