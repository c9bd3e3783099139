#ifndef GLINT_GPU_RECORDS_SHARED_H
#define GLINT_GPU_RECORDS_SHARED_H
#include "math/shared.h"
#ifndef GLINT_GLSL
#include <cstddef>
#endif

// What the host and the shader tell each other: settings, and the layout of the buffers that both touch. The
// host fills structs, the shader reads the same structs: std140 for the settings, std430 for buffers. In both
// a vec3 is followed by a scalar of four bytes, so that C++ has no other layout.

GLINT_SHARED_BEGIN

/// The terms of the light (glint/term.h).
const uint term_ambient = 0u;
const uint term_diffuse = 1u;
const uint term_highlight = 2u;
const uint term_clamp = 3u;
const uint term_reflection = 4u;
const uint term_transmission = 5u;
const uint term_emission = 6u;

/// The uniform block: all that a dispatch is told beside the scene's buffers.
struct GpuSettings {
    // The camera; its vectors are those of PinholeCamera.
    vec3 camera_eye;
    float image_width; ///< pixels
    vec3 camera_forward;
    float image_height;
    vec3 camera_right;
    float filter_radius; ///< pixels
    vec3 camera_up;
    float index_outside;    ///< of refraction, outside all solids
    uvec4 interiors_at_eye; ///< the transparent solids around the eye, as rays carry them
    uint seed_low;
    uint seed_high;
    uint filter_steps;          ///< of the filter's table
    uint negative_filter_steps; ///< its outermost steps, on which the filter is below 0

    // The scene.
    vec3 ambient_light;
    float max_coordinate; ///< the largest |coordinate| of boxes in the world
    vec3 background;
    float instance_slack; ///< what boxes of instances grow by, in |coordinates| of a ray's origin
    uint max_depth;
    uint light_count;
    uint plane_count;
    uint mesh_count;     ///< meshes in the world's own space
    uint opaque_shadows; ///< this and the next three: 0 or 1
    uint clamp_light;
    uint balanced_energy;
    uint phong_highlights;
    uint first_quadric; ///< this and the next two: in doubles of the shapes
    uint first_affine;
    uint first_instance;
    uint tree_root;      ///< none: only planes
    uint first_light;    ///< this and the next: in vectors of the tables
    uint first_tail;     ///< of the filter
    uint first_interior; ///< in words: the transparent solids by rank

    // The dispatch.
    uint max_walk_steps; ///< after so many turns of its walks a slot waits for the next dispatch
    uint tile_x;         ///< the first pixel
    uint tile_y;
    uint tile_width; ///< in slots, a multiple of square_width
    uint pixel_step; ///< pixels from one slot's to the next's
    uint end_x;      ///< past the last pixel
    uint end_y;
    uint samples;      ///< a pixel, in the whole picture
    uint first_sample; ///< samples before
    uint end_sample;   ///< take samples up to this one
    uint first_slot;
    uint end_slot;
    uint slot_count; ///< of the tile: the stride of their fields
    uint max_nodes;  ///< of ray trees that a slot follows
    uint aov;        ///< what is shown of first hits (render/aspect.shared.h)
    uint any_hit;    ///< rays.glsl: 1 ends each search with the first hit that is found

    // From a film to a picture: show.glsl.
    uint show_mode;
    uint known_step;    ///< each of so many pixels of a row and column is known
    uint known_samples; ///< of each pixel
    uint film_terms;    ///< terms that the film keeps apart
    uint shown_term;    ///< one of them
    uint smooth_steps;  ///< 1: linear between known pixels, 0: blocks
    uint reserved_1;    ///< these three: 0, for std140 rounds the size up to a multiple of 16 bytes
    uint reserved_2;
    uint reserved_3;
};

// GpuSettings::show_mode
const uint show_centres = 0u; // from the film to the image of known pixels
const uint show_spread = 1u;  // the known pixels with what lies between them
const uint show_means = 2u;   // of known_samples samples each
const uint show_started = 3u; // of as many samples as each pixel has by now

// Slots, each a pixel of the tile, go through it in squares.
const uint square_width = 8u;
const uint square_slots = 64u;

// The buffer of work: counters, then the fields of the slots, each field of all slots side by side: sample,
// state, three for each term, then those of the rays that wait.
const uint counter_unfinished = 0u; // slots
const uint counter_faults = 1u;     // bits: fault_interiors, fault_loops
const uint counter_rays = 2u;       // primary, reflected, refracted, shadow
const uint work_counters = 16u;
const uint fault_interiors = 1u; // a ray was in more solids than it can carry
const uint fault_loops = 2u;     // the driver ended a loop
const uint field_sample = 0u;
const uint field_state = 1u;
const uint field_terms = 2u;
const uint fields_of_term = 3u;
const uint fields_of_ray = 14u;

// The film: the terms' sums over samples of weight +1, those of weight −1, the number of samples of weight
// +1, and of samples that hit something, each of all slots side by side.
const uint film_fields_of_term = 6u;
const uint film_counts = 2u;

#ifndef GLINT_GLSL
static_assert(offsetof(GpuSettings, interiors_at_eye) == 64 && offsetof(GpuSettings, ambient_light) == 96 &&
              offsetof(GpuSettings, max_depth) == 128 && sizeof(GpuSettings) == 288);
#endif

GLINT_SHARED_END
#endif
