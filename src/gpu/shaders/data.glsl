// The settings and the buffers that the host fills (gpu/scene_data.h). OpenGL 4.3 guarantees eight buffers.

layout(std430, binding = 0) readonly buffer Nodes { NodeRecord nodes[]; };
layout(std430, binding = 1) readonly buffer Leaves { uint leaves[]; }; // trace/mesh/tree.h: leaf_words
layout(std430, binding = 2) readonly buffer Objects { ObjectRecord objects[]; };
layout(std430, binding = 3) readonly buffer Words { uint words[]; }; // mesh ranges, interiors, vertex data
layout(std430, binding = 4) readonly buffer Lights {
    FilterTable filter_table;
    LightRecord lights[];
};
layout(std430, binding = 5) readonly buffer Shapes { ShapeRecord shapes[]; }; // planes, then quadrics
layout(std430, binding = 6) buffer Work { uint work[]; };
layout(std430, binding = 7) buffer Film { float film[]; };

layout(std140, binding = 0) uniform SettingsBlock { GpuSettings settings; };

bool object_is(uint object, uint flag) { return (objects[object].flags & flag) != 0u; }

dvec3 unpacked(PackedVector v) { return dvec3(v.x, v.y, v.z); }
dmat3 unpacked(PackedMatrix m) {
    return dmat3(unpacked(m.columns[0]), unpacked(m.columns[1]), unpacked(m.columns[2]));
}

// The words begin with two pairs for each mesh in the world's own space, in order of triangle numbers:
// numbers of narrow triangles come before those of wide ones.
uint mesh_first_triangle(uint mesh) { return words[2u * mesh]; }
uint mesh_object(uint mesh) { return words[2u * mesh + 1u]; }

/// Element i of an array of vectors that begins at `array` (ObjectRecord).
uvec3 array_corners(uint array, uint i) {
    uint at = array + 3u * i;
    return uvec3(words[at], words[at + 1u], words[at + 2u]);
}
vec3 array_vector(uint array, uint i) { return uintBitsToFloat(array_corners(array, i)); }

/// The elements of a triangle's corners, as columns.
mat3 array_vectors(uint array, uvec3 corner) {
    return mat3(array_vector(array, corner.x), array_vector(array, corner.y), array_vector(array, corner.z));
}
