#ifndef GLINT_GPU_RECORDS_SHARED_H
#define GLINT_GPU_RECORDS_SHARED_H
#include "imaging/filter.shared.h"
#include "math/shared.h"
#include "shading/records.shared.h"
#ifndef GLINT_GLSL
#include "math/index.h"

#include <cstddef>
#endif

// Settings and records that the host fills and the shader reads, and the layout of the buffers that both use:
// std140 for the settings, std430 for buffers. In both a vec3 is followed by a scalar of four bytes, which
// gives C++ the same layout.

GLINT_SHARED_BEGIN

#ifdef GLINT_GLSL
const uint invalid_index = 0xffffffffu; // math/index.h
#endif

// Vectors and matrices of doubles without the gaps of std430, which aligns dvec3 to 32 bytes.
#ifdef GLINT_GLSL
struct PackedVector {
    double x;
    double y;
    double z;
};
struct PackedMatrix {
    PackedVector columns[3];
};
#else
using PackedVector = dvec3;
using PackedMatrix = dmat3;
#endif

/// Eight children of the tree: gpu/tree.h has their layout.
struct NodeRecord {
    vec3 origin;
    uint exponents_and_mask; ///< of x, y, z: 8 bits each, biased by 127; then which children there are
    uint children[8];        ///< codes
    uvec4 sides_x; ///< a byte each: low sides of children 0 to 3, of 4 to 7, high sides the same way
    uvec4 sides_y;
    uvec4 sides_z;
};

/// A plane, or a quadric in its object's local space.
struct ShapeRecord {
    int kind; ///< of a quadric: quadric_sphere, …
    uint object;
    uint prim;         ///< within its object
    uint is_local;     ///< 1: ObjectRecord has the transform of its local space
    PackedVector base; ///< as in QuadricShape
    PackedVector axis; ///< as in QuadricShape; of a plane its normal
    double height;     ///< as in QuadricShape; of a plane its offset
    double radius;
};

// ObjectRecord::flags
const uint object_lit_as_stored = 1u;  ///< lights find its normals as its winding has them
const uint object_turned = 2u;         ///< its normals are turned against the winding
const uint object_reversed = 4u;       ///< the same, against the winding as its triangles are stored
const uint object_instance = 8u;       ///< its triangles are those of a shared mesh, in a local space
const uint object_local_normals = 16u; ///< its vertex normals go to the world by normal_matrix

/// An object with its material, and with the transform of its local space if it is an instance or a quadric
/// that is stretched.
struct ObjectRecord {
    MaterialRecord material;
    uint rank; ///< of overlapping solids the one of higher rank owns the space
    uint flags;
    uint interior;  ///< number of a transparent solid among all of them, by rank, from 1; 0 for others
    uint mesh_root; ///< of an instance
    uint corners;   ///< this and the next two: indices of a mesh's arrays in the words, or invalid_index
    uint normals;
    uint colors;
    float mesh_max_coordinate; ///< of an instance: the largest |coordinate| of its tree's boxes
    vec3 contact_low;          ///< this and the next three: scene::ContactZone
    float contact_apart;
    vec3 contact_high;
    float contact_reach;
    PackedMatrix linear; ///< p_world = linear · p_local + translation
    PackedMatrix inverse;
    PackedVector translation;
    double slack;               ///< error of the transform to the world and back in double
    PackedMatrix normal_matrix; ///< see object_local_normals
    double off_edges;           ///< of a mesh: how far rays start from edges (geometry/surface.shared.h)
};

/// The share of the pixel filter beyond a distance of radius · (1 − i / filter_steps).
struct FilterTable {
    float tails[filter_steps + 1];
    float reserved[3]; ///< 0
};

/// The terms of the light (glint/term.h).
const uint term_ambient = 0u;
const uint term_diffuse = 1u;
const uint term_highlight = 2u;
const uint term_clamp = 3u;
const uint term_reflection = 4u;
const uint term_transmission = 5u;
const uint term_emission = 6u;

/// The uniform block.
struct GpuSettings {
    // The camera; its vectors are those of PinholeCamera.
    vec3 camera_eye;
    float image_width; ///< pixels
    vec3 camera_forward;
    float image_height;
    vec3 camera_right;
    float filter_radius; ///< pixels
    vec3 camera_up;
    float max_coordinate;   ///< the largest |coordinate| of boxes in the world
    uvec4 interiors_at_eye; ///< the transparent solids around the eye, as rays carry them
    uint seed_low;
    uint seed_high;
    uint samples;               ///< a pixel, in the whole picture
    uint negative_filter_steps; ///< its outermost steps, on which the filter is below 0

    // The scene.
    vec3 ambient_light;
    float instance_slack; ///< what boxes of instances grow by, in |coordinates| of a ray's origin
    vec3 background;
    uint max_depth;
    uint light_count;
    uint plane_count;
    uint mesh_count; ///< meshes in the world's own space
    uint tree_root;  ///< invalid_index: only planes
    WhittedModes modes;
    float min_weight;    ///< WhittedSettings::min_weight
    uint first_interior; ///< in words: the object of the outside, then the transparent solids by rank

    // The dispatch.
    uint max_walk_steps; ///< after so many traversal steps a slot waits for the next dispatch
    uint tile_x;         ///< the first pixel
    uint tile_y;
    uint tile_width; ///< in slots, a multiple of square_width
    uint pixel_step; ///< pixels from one slot's to the next's
    uint end_x;      ///< past the last pixel
    uint end_y;
    uint first_sample; ///< samples before
    uint end_sample;   ///< past the last sample
    uint first_slot;
    uint end_slot;
    uint slot_count;       ///< of the tile: the stride of their fields
    uint max_nodes;        ///< of ray trees, for each slot
    int aov;               ///< what is measured at first hits (render/aov.shared.h)
    uint any_hit;          ///< rays.glsl: 1: any hit will do
    uint hides_background; ///< 1: camera rays that hit nothing bring nothing

    // From a film to a picture: show.glsl.
    uint show_mode;
    uint known_step;      ///< each of so many pixels of a row and column is known
    uint known_samples;   ///< of each pixel
    uint film_terms;      ///< terms that the film sums separately
    uint shown_term;      ///< one of them
    uint smooth_steps;    ///< 1: linear between known pixels, 0: blocks
    uint first_wide_leaf; ///< from here on leaves have wide triangles: an offset as in their codes
    uint reserved_1;      ///< std140 rounds the size up to a multiple of 16 bytes
    uint reserved_2;
    uint reserved_3;
};

// GpuSettings::show_mode
const uint show_centres = 0u; // from the film to the image of known pixels
const uint show_means = 1u;   // of known_samples samples; without any, what is between the known pixels
const uint show_started = 2u; // the same, of those that each pixel has got since as well

// A slot is a pixel of the tile. Slots are numbered square by square.
const uint square_width = 8u;
const uint square_slots = 64u;

/// The pixel of a slot, in a tile of so many slots across.
GLINT_FN uvec2 pixel_of_slot(uint slot, uint tile_width) {
    uint square = slot / square_slots;
    uint columns = tile_width / square_width;
    return uvec2(square_width * (square % columns) + slot % square_width,
                 square_width * (square / columns) + slot % square_slots / square_width);
}

// The buffer of work: counters, then the fields of the slots, each field of all slots side by side: sample,
// state, three for each term, then those of the rays that wait.
const uint counter_unfinished = 0u; // slots
const uint counter_faults = 1u;     // bits: fault_interiors, fault_loops
const uint counter_rays = 2u;       // primary, reflected, refracted, shadow
const uint counter_left_out = 6u;   // rays below min_weight
const uint work_counters = 16u;
const uint fault_interiors = 1u; // a ray was in more solids than its list has room for
const uint fault_loops = 2u;     // the driver ended a loop early
const uint field_sample = 0u;
const uint field_state = 1u;
const uint field_terms = 2u;
const uint fields_of_term = 3u;
const uint fields_of_ray = 14u;

// The film: the terms' sums over samples of weight +1, those of weight −1, the number of samples of weight
// +1, and of samples of weight +1 and −1 that hit something, each of all slots side by side.
const uint film_fields_of_term = 6u;
const uint film_counts = 3u;

#ifndef GLINT_GLSL
static_assert(offsetof(GpuSettings, interiors_at_eye) == 64 && offsetof(GpuSettings, ambient_light) == 96 &&
              offsetof(GpuSettings, light_count) == 128 && offsetof(GpuSettings, modes) == 144 &&
              sizeof(GpuSettings) == 272);
static_assert(offsetof(NodeRecord, children) == 16 && offsetof(NodeRecord, sides_x) == 48 &&
              sizeof(NodeRecord) == 96);
static_assert(sizeof(PackedVector) == 24 && sizeof(PackedMatrix) == 72);
static_assert(offsetof(ShapeRecord, base) == 16 && sizeof(ShapeRecord) == 80);
static_assert(offsetof(ObjectRecord, rank) == 176 && offsetof(ObjectRecord, linear) == 240 &&
              offsetof(ObjectRecord, normal_matrix) == 416 && sizeof(ObjectRecord) == 496);
static_assert(sizeof(FilterTable) % 16 == 0);
#endif

GLINT_SHARED_END
#endif
