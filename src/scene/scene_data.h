#pragma once
// Contents of a Scene: single precision, resolved names, trees. Made by build_scene(), read by render/ and
// gpu/.

#include "geometry/surface.shared.h"
#include "glint/scene.h"
#include "math/vec.h"
#include "scene/light_set.h"
#include "shading/records.shared.h"
#include "trace/world/world.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace glint::scene {

class BoxTree;

/// Vertex attributes of a mesh, shared by its instances.
struct MeshAttributes {
    /// Per vertex; null without interpolation. Unit vectors in world space or, if the object has a normal
    /// matrix, of any length in the mesh's space.
    std::shared_ptr<const std::vector<vec3>> normals;
    std::shared_ptr<const Mesh> mesh; ///< for indices and colours
    bool colored = false;
};

inline constexpr std::int32_t no_attributes = -1;
inline constexpr std::int32_t no_normal_matrix = -1;

/// Where an object's surface may coincide with that of another, for most objects nowhere; and how far apart
/// the two are there, but for the rounding of points.
struct ContactZone {
    Bounds box;
    float apart = 0;
    float reach = 0; ///< as in last_coincident_t()
};

/// Parallel to SceneDescription::objects.
struct ObjectData {
    std::uint32_t material = 0;
    std::uint32_t rank = 0;     ///< of overlapping solids the one with the highest rank owns the space
    bool solid = false;         ///< closed, so it has an inside
    bool lit_as_stored = false; ///< shading uses normals by the winding (Facing::stored)
    bool turned =
        false;     ///< normals are opposite to those by the winding as stored, carried along by the transform
    Bounds bounds; ///< world space; empty for planes and invisible objects
    ContactZone contact;
    Bounds core; ///< the same, without the outliers of a point cloud
    std::int32_t attributes = no_attributes;
    std::int32_t normal_matrix = no_normal_matrix; ///< index into SceneData::normal_matrices
};

/// A solid plane: the half-space behind its normal is inside.
struct HalfSpace {
    std::uint32_t object = 0;
    trace::WorldInput::Plane plane;
};

struct SceneData {
    /// The world is traced about this point of the scene: zero, unless the scene lies far from zero compared
    /// with its size. All positions here are relative to it, except for those of `given`.
    dvec3 origin{0};
    SceneDescription description;                  ///< with its camera filled in
    std::shared_ptr<const SceneDescription> given; ///< the same as given; null if the origin is zero
    bool has_own_camera = false;                   ///< before it was filled in
    /// Identifies everything but the view: equal for scenes made from each other by with_view().
    std::shared_ptr<const int> all_but_view;
    trace::World world;
    std::vector<MaterialRecord> materials;
    std::vector<ObjectData> objects;
    std::vector<MeshAttributes> attributes;
    std::vector<dmat3> normal_matrices;        ///< of instances, from the mesh's space to the world
    std::vector<LightRecord> lights;           ///< lights except ambient ones, in file order
    std::shared_ptr<const LightSet> light_set; ///< what path tracers sample; null for other integrators
    vec3 ambient{0.0f};                        ///< sum of the ambient lights
    vec3 background{0.0f};
    float index_outside = 1;
    bool any_transparent = false;
    bool any_see_through = false;    ///< some material is transparent, or of an opacity below 1
    bool any_front_emission = false; ///< some material emits from its front alone
    bool any_contact = false;        ///< some object has a contact zone
    /// Where pairs of objects touch; null where that is nowhere or, for planes, everywhere.
    std::shared_ptr<const BoxTree> contact_places;
    bool solids_known = false; ///< ObjectData::solid is valid for meshes too
    std::vector<HalfSpace> half_spaces;
    std::vector<std::uint32_t> camera_interiors; ///< transparent solids around the eye, lowest rank first
};

/// The settings in the form used by shading/whitted.shared.h.
inline WhittedModes whitted_modes(const WhittedSettings& settings) {
    WhittedModes modes{};
    modes.opaque_shadows = settings.shadows == Shadows::opaque ? 1 : 0;
    modes.clamp = settings.clamp ? 1 : 0;
    modes.balanced = settings.energy == Energy::balanced ? 1 : 0;
    modes.highlight = settings.highlight_model == HighlightModel::phong ? highlight_phong : highlight_blinn;
    return modes;
}

/// The objects crossed an odd number of times by a ray from the point, which contain it if closed. Without
/// planes.
std::vector<std::uint32_t> surfaces_around(const SceneData& scene, const vec3& point);

/// The solids that contain a point, judged by the parity of crossings, including solid planes.
std::vector<std::uint32_t> objects_around(const SceneData& scene, const vec3& point);

} // namespace glint::scene
