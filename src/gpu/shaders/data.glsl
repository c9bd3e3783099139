// The buffers that the host fills (gpu/scene_data.h). Records are found by their numbers; where each kind begins
// is in the settings.

layout(std430, binding = 0) readonly buffer Nodes { uvec4 nodes[]; };     // six to a node
layout(std430, binding = 1) readonly buffer Leaves { uint leaves[]; };    // trace/mesh_tree.h: leaf_words
layout(std430, binding = 2) readonly buffer Objects { uvec4 objects[]; }; // two to an object
layout(std430, binding = 3) readonly buffer Words { uint words[]; };      // meshes, media, attributes
layout(std430, binding = 4) readonly buffer Tables { vec4 tables[]; };    // materials, lights, filter
layout(std430, binding = 5) readonly buffer Shapes { double shapes[]; };  // planes, quadrics, places
layout(std430, binding = 6) buffer Work { uint work[]; };                 // counters, rays that wait
layout(std430, binding = 7) buffer Film { float film[]; };                // sums over samples

layout(std140, binding = 0) uniform SettingsBlock { GpuSettings settings; };

const uint none = 0xffffffffu;

// Flags of objects.
const uint object_solid = 1u;
const uint object_lit_as_stored = 2u;
const uint object_turned = 4u; // its normals are turned against the winding
const uint object_fresnel = 8u;

uint object_material(uint object) { return objects[2u * object].x; }
uint object_rank(uint object) { return objects[2u * object].y; }
bool object_is(uint object, uint flag) { return (objects[2u * object].z & flag) != 0u; }
/// The number of a transparent solid among all of them, by rank, from 1; 0 for other objects.
uint object_medium(uint object) { return objects[2u * object].w; }
/// Offsets of words, or `none`: corners, normals, colours; then the matrix of its normals, of doubles.
uvec4 object_attributes(uint object) { return objects[2u * object + 1u]; }

struct Material {
    vec3 color;
    vec3 emission;
    vec3 absorption;
    float ambient;
    float diffuse;
    float highlight;
    float shininess;
    float reflectivity;
    float transparency;
    float index;
};

float material_transparency(uint material) { return tables[4u * material + 3u].y; }
float material_index(uint material) { return tables[4u * material + 3u].z; }
vec3 material_absorption(uint material) { return tables[4u * material + 2u].xyz; }

Material material_at(uint material) {
    vec4 a = tables[4u * material];
    vec4 b = tables[4u * material + 1u];
    vec4 c = tables[4u * material + 2u];
    vec4 d = tables[4u * material + 3u];
    return Material(a.xyz, b.xyz, c.xyz, a.w, b.w, c.w, d.x, d.w, d.y, d.z);
}

const int light_point = 0;
const int light_directional = 1;
const int light_spot = 2;

struct Light {
    int kind;
    vec3 position;
    vec3 direction;
    vec3 strength;
    float cos_outer;
    float cos_inner;
};

Light light_at(uint light) {
    uint at = settings.first_light + 3u * light;
    vec4 a = tables[at];
    vec4 b = tables[at + 1u];
    vec4 c = tables[at + 2u];
    return Light(int(a.w), a.xyz, b.xyz, c.xyz, b.w, c.w);
}

dvec3 shape_vector(uint at) { return dvec3(shapes[at], shapes[at + 1u], shapes[at + 2u]); }
dmat3 shape_matrix(uint at) {
    return dmat3(shape_vector(at), shape_vector(at + 3u), shape_vector(at + 6u));
}
vec3 word_vector(uint at) {
    return vec3(uintBitsToFloat(words[at]), uintBitsToFloat(words[at + 1u]), uintBitsToFloat(words[at + 2u]));
}
