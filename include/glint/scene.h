#pragma once
// Scenes as plain, editable values (`SceneDescription`), and built for tracing (`Scene`). Names and meanings
// are those of scene files: docs/scene-format.md.

#include "glint/enum_names.h"
#include "glint/error.h"
#include "glint/filter.h"
#include "glint/fov_axis.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace glint {

using Vec3 = glm::dvec3;
using Mat4 = glm::dmat4; ///< column-major: m[column][row]

/// A triangle mesh, or a point cloud if `triangles` is empty. Vertex i is at origin + positions[i], in scene
/// units before MeshShape::scale. Readers choose an origin near meshes that lie far from zero compared with
/// their size, since positions in single precision could not resolve them.
struct Mesh {
    std::vector<glm::vec3> positions; ///< relative to `origin`
    std::vector<glm::vec3> normals;   ///< per vertex, or empty
    std::vector<glm::vec3> colors;    ///< per vertex, linear RGB, or empty
    std::vector<glm::vec2> uvs;       ///< per vertex, or empty
    std::vector<glm::uvec3> triangles;
    Vec3 origin{0};
};

/// A direction along an axis.
enum class Axis { x, y, z, minus_x, minus_y, minus_z };
template <>
inline constexpr NamesUpTo<Axis::minus_z> enum_names<Axis>{"x", "y", "z", "-x", "-y", "-z"};

/// A pinhole camera, right-handed.
struct CameraDescription {
    Vec3 eye{0};
    Vec3 direction{0, 1, 0}; ///< viewing direction; any length
    Vec3 up{0, 0, 1};
    double fov = 45; ///< full angle, degrees
    FovAxis fov_axis = FovAxis::y;
    Location where;
};

enum class Integrator { whitted, path, path_simple, direct, ambient_occlusion };
template <>
inline constexpr NamesUpTo<Integrator::ambient_occlusion> enum_names<Integrator>{
    "whitted", "path", "path-simple", "direct", "ambient-occlusion"};

/// Whether it estimates all light by paths, in the units of light that they share.
constexpr bool traces_paths(Integrator integrator) {
    return integrator == Integrator::path || integrator == Integrator::path_simple ||
           integrator == Integrator::direct;
}

struct RenderSettings {
    int width = 640;
    int height = 480;
    std::optional<int> spp; ///< samples per pixel; 1: through its centre; none: see sample_counts()
    int max_spp = 0;        ///< samples of each pixel that differs from a neighbour, if more than `spp`
    std::uint64_t seed = 0;
    Integrator integrator = Integrator::whitted;
    PixelFilter filter = PixelFilter::box;
    Vec3 background{0}; ///< linear RGB
};

/// Samples of the pixels of a picture.
struct SampleCounts {
    int all = 1;       ///< of each pixel
    int differing = 0; ///< of those that differ from a neighbour, instead; 0: of none

    bool adaptive() const { return differing > 0; }
    /// About how many a pixel has: in ordinary pictures a fifth of the pixels differ.
    double mean() const { return all + 0.2 * differing; }
    friend bool operator==(const SampleCounts&, const SampleCounts&) = default;
};

/// What `spp` and `max_spp` say. Without `spp`, pixels have 1 sample, and 8 where they differ from a
/// neighbour; where noise differs everywhere all have the same, 64 for paths, 4 for ambient occlusion.
SampleCounts sample_counts(const RenderSettings& settings);

enum class Shadows { transmissive, opaque };
template <>
inline constexpr NamesUpTo<Shadows::opaque> enum_names<Shadows>{"transmissive", "opaque"};
enum class Energy { report, balanced };
template <>
inline constexpr NamesUpTo<Energy::balanced> enum_names<Energy>{"report", "balanced"};
enum class HighlightModel { blinn, phong };
template <>
inline constexpr NamesUpTo<HighlightModel::phong> enum_names<HighlightModel>{"blinn", "phong"};

struct WhittedSettings {
    int max_depth = 8;        ///< bounces after the first hit
    double min_weight = 1e-5; ///< share of a sample's light below which no ray is followed
    Shadows shadows = Shadows::transmissive;
    bool clamp = false;
    Energy energy = Energy::report;
    bool energy_chosen = false; ///< written down: materials that give more light than they get are meant
    HighlightModel highlight_model = HighlightModel::blinn;
    double index = 1.0; ///< index of refraction of the surroundings
};

enum class LightSampling { uniform, power, tree };
template <>
inline constexpr NamesUpTo<LightSampling::tree> enum_names<LightSampling>{"uniform", "power", "tree"};
/// What shadow rays of paths pass, beside thin panes.
enum class PathShadows {
    exact,       ///< nothing: light through solid glass arrives by paths
    transmissive ///< solid glass, unbent, as in Whitted's model
};
template <>
inline constexpr NamesUpTo<PathShadows::transmissive> enum_names<PathShadows>{"exact", "transmissive"};

/// Bounces are counted after the first hit. Those by mirrors and smooth glass are specular, all others
/// diffuse; going straight through a thin pane is neither.
struct PathSettings {
    int max_depth = 32;
    int max_diffuse_bounces = 1000; ///< beside max_depth
    int roulette_depth = 4;         ///< the first bounce that may end a path for its small weight
    LightSampling light_sampling = LightSampling::tree;
    double clamp_indirect = 0; ///< largest radiance of a sample's indirect light; 0: as it is
    PathShadows shadows = PathShadows::exact;
};

struct AmbientOcclusionSettings {
    std::optional<double> distance; ///< scene units; none: a tenth of the diagonal of everything finite
    bool colored = false;           ///< times the colour of the surface
};

/// What a material's numbers mean. Both light models read all of them: docs/light-model.md.
enum class MaterialModel { whitted, diffuse, conductor, dielectric, plastic, principled };
template <>
inline constexpr NamesUpTo<MaterialModel::principled> enum_names<MaterialModel>{
    "whitted", "diffuse", "conductor", "dielectric", "plastic", "principled"};

/// Metals whose complex index of refraction is known.
enum class Metal { aluminium, brass, chromium, cobalt, copper, gold, iron, nickel, silver, titanium };
template <>
inline constexpr NamesUpTo<Metal::titanium> enum_names<Metal>{
    "aluminium", "brass", "chromium", "cobalt", "copper", "gold", "iron", "nickel", "silver", "titanium"};

/// Sides of a surface: front is the one of its normal as the object has it.
enum class EmissionSides { both, front };
template <>
inline constexpr NamesUpTo<EmissionSides::front> enum_names<EmissionSides>{"both", "front"};

/// A model reads the members that scene files have for it. Those that all models have are `color`, `ambient`,
/// `emission`, `emission_sides` and `opacity`.
struct Material {
    std::string name;
    MaterialModel model = MaterialModel::whitted;
    Vec3 color{0.8};         ///< linear RGB; scene files give dielectrics white
    double ambient = 1;      ///< k_a, read by Whitted's light model alone
    double diffuse = 1;      ///< k_d
    double highlight = 0;    ///< k
    double shininess = 32;   ///< m, the report's n
    double reflectivity = 0; ///< ρ
    double transparency = 0; ///< τ, 0 … 1
    double index = 1.5;      ///< η, used by `whitted` where transparency > 0
    Vec3 absorption{0};      ///< σ, per scene unit, inside solids
    bool fresnel = false;
    double roughness = 0;       ///< 0 … 1, α = roughness²; scene files give plastic 0.2, principled 0.5
    std::optional<Metal> metal; ///< of a conductor, instead of `color`
    double metallic = 0;
    double transmission = 0;
    double clearcoat = 0;
    double clearcoat_roughness = 0;
    double sheen = 0;
    Vec3 sheen_color{1};
    double sheen_roughness = 0.5;
    double specular = 1;
    Vec3 specular_color{1};
    double opacity = 1;
    Vec3 emission{0};
    EmissionSides emission_sides = EmissionSides::both;
    Location where;
};

/// Whether light goes through it: solids of it are filled with a medium.
bool is_transparent(const Material& material);

/// The points with normal · p = offset; the normal need not be normalized.
struct PlaneShape {
    Vec3 normal{0, 0, 1};
    double offset = 0;
    bool solid = false; ///< the half-space behind the normal
    friend bool operator==(const PlaneShape&, const PlaneShape&) = default;
};
struct SphereShape {
    Vec3 center{0};
    double radius = 1;
    friend bool operator==(const SphereShape&, const SphereShape&) = default;
};
/// A solid cylinder with caps; only the direction of `axis` matters.
struct CylinderShape {
    Vec3 base{0};
    Vec3 axis{0, 0, 1};
    double height = 1;
    double radius = 1;
    friend bool operator==(const CylinderShape&, const CylinderShape&) = default;
};
/// A solid cone with its cap; `axis` gives the direction only, from the middle of the base to the apex.
struct ConeShape {
    Vec3 base{0};
    Vec3 axis{0, 0, 1};
    double height = 1;
    double radius = 1;
    friend bool operator==(const ConeShape&, const ConeShape&) = default;
};
/// A flat disk, seen from both sides; the normal may have any length.
struct DiskShape {
    Vec3 center{0};
    Vec3 normal{0, 0, 1};
    double radius = 1;
    friend bool operator==(const DiskShape&, const DiskShape&) = default;
};
struct TriangleShape {
    std::array<Vec3, 3> vertices{};
    friend bool operator==(const TriangleShape&, const TriangleShape&) = default;
};
/// A flat parallelogram, seen from both sides: a rectangle where its edges are perpendicular. Its normal is
/// u × v.
struct RectangleShape {
    Vec3 corner{0};
    Vec3 u{1, 0, 0}; ///< an edge from the corner
    Vec3 v{0, 1, 0}; ///< the other one
    friend bool operator==(const RectangleShape&, const RectangleShape&) = default;
};
enum class PolyhedronKind { box, tetrahedron, octahedron, dodecahedron, icosahedron, prism, pyramid };
template <>
inline constexpr NamesUpTo<PolyhedronKind::pyramid> enum_names<PolyhedronKind>{
    "box", "tetrahedron", "octahedron", "dodecahedron", "icosahedron", "prism", "pyramid"};
struct PolyhedronShape {
    PolyhedronKind kind = PolyhedronKind::box;
    Vec3 center{0};
    Vec3 size{1};       ///< box: edge lengths
    double radius = 1;  ///< all others: radius of the circumscribed sphere
    int sides = 6;      ///< prism, pyramid
    double height = 1;  ///< prism, pyramid
    Vec3 axis{0, 0, 1}; ///< prism, pyramid
    friend bool operator==(const PolyhedronShape&, const PolyhedronShape&) = default;
};
enum class NormalsMode { automatic, flat, smooth };
template <>
inline constexpr NamesUpTo<NormalsMode::smooth> enum_names<NormalsMode>{"auto", "flat", "smooth"};
/// How a mesh's normals are oriented for lighting.
enum class Facing {
    viewer, ///< toward the viewer, like all other shapes
    stored  ///< by the winding: an open mesh is lit from inside through its back
};
template <>
inline constexpr NamesUpTo<Facing::stored> enum_names<Facing>{"viewer", "stored"};
enum class VertexColors { automatic, ignore };
template <>
inline constexpr NamesUpTo<VertexColors::ignore> enum_names<VertexColors>{"auto", "ignore"};
struct MeshShape {
    std::string file; ///< as written in the scene file; empty for a mesh made in memory
    Vec3 scale{1};    ///< applied before the object's transform
    NormalsMode normals = NormalsMode::automatic;
    double crease_angle = 180; ///< degrees: with smooth normals, faces that meet at more have an edge
    Facing facing = Facing::viewer;
    VertexColors vertex_colors = VertexColors::automatic;
    std::optional<double> point_radius; ///< radius for point clouds; none: chosen by density
    std::shared_ptr<const Mesh> data;   ///< set by load_scene() or by hand
    friend bool operator==(const MeshShape&, const MeshShape&) = default;
};
/// An instance of a mesh: the mesh's scale and transform first, then this object's.
struct InstanceShape {
    std::string mesh; ///< name of a mesh object
    friend bool operator==(const InstanceShape&, const InstanceShape&) = default;
};
using Shape = std::variant<PlaneShape, SphereShape, CylinderShape, ConeShape, DiskShape, TriangleShape,
                           RectangleShape, PolyhedronShape, MeshShape, InstanceShape>;

/// Their tables: [[plane]], [[sphere]], …
inline constexpr std::array<std::string_view, std::variant_size_v<Shape>> shape_names{
    "plane", "sphere", "cylinder", "cone", "disk", "triangle", "rectangle", "polyhedron", "mesh", "instance"};
static_assert(!shape_names.back().empty(), "a shape has no name");

/// Several of them, in prose.
inline constexpr std::array<std::string_view, std::variant_size_v<Shape>> shape_plurals{
    "planes",    "spheres",    "cylinders", "cones",  "disks",
    "triangles", "rectangles", "polyhedra", "meshes", "instances"};
static_assert(!shape_plurals.back().empty(), "a shape has no plural");

constexpr std::string_view name_of(const Shape& shape) { return shape_names[shape.index()]; }

struct Object {
    std::string name; ///< unique within its type, or empty
    Shape shape;
    std::string material; ///< material name; an instance without one uses its mesh's
    bool visible = true;
    int priority = 0; ///< of overlapping solids the one with higher priority owns the space
    Mat4 transform{1.0};
    Location where;
};

/// strength(): the light that it sends, in the unit of its intensity or irradiance.
struct AmbientLight {
    Vec3 color{0.1};
    Vec3 strength() const { return color; }
};
struct PointLight {
    Vec3 position{0};
    Vec3 color{1};
    double intensity = 1; ///< a white matte surface facing it at distance 1 has radiance 1.0
    Vec3 strength() const { return color * intensity; }
};
struct DirectionalLight {
    Vec3 direction{0, 0, -1}; ///< direction of travel; any length
    Vec3 color{1};
    double irradiance = 1;
    Vec3 strength() const { return color * irradiance; }
};
struct SpotLight {
    Vec3 position{0};
    Vec3 direction{0, 0, -1};
    double angle = 30; ///< half angle of the cone, degrees
    double blend = 0.1;
    Vec3 color{1};
    double intensity = 1;
    Vec3 strength() const { return color * intensity; }
};
struct Light {
    std::variant<AmbientLight, PointLight, DirectionalLight, SpotLight> kind;
    Location where;
    std::string name = {}; ///< unique among lights, or empty
};

/// The types of [[light]].
inline constexpr std::array<std::string_view, std::variant_size_v<decltype(Light::kind)>> light_names{
    "ambient", "point", "directional", "spot"};
static_assert(!light_names.back().empty(), "a light has no name");

constexpr std::string_view name_of(const Light& light) { return light_names[light.kind.index()]; }

/// Whether a shape bounds a volume. A mesh is taken to: building its scene finds out.
bool is_solid(const Shape& shape);

struct SceneDescription;

/// How a scene without a camera is shown: everything finite in it, as large as the picture allows.
struct Framing {
    std::optional<Vec3> direction; ///< of view; none: from the front, a little from the left and from above
    Vec3 up{0, 0, 1};
    double fov = 40; ///< full angle, degrees
    FovAxis fov_axis = FovAxis::y;
    double fill = 0.85; ///< share of the picture that may be filled
    /// Moments of an animation: all of these are shown instead, so that its frames have one camera.
    std::shared_ptr<const std::vector<SceneDescription>> moments;
};

/// The contents of a scene file. Objects and lights are in file order, which decides ties and sums.
struct SceneDescription {
    std::optional<CameraDescription> camera; ///< none: chosen by build_scene(), see Framing
    Framing framing;
    RenderSettings render;
    WhittedSettings whitted;
    PathSettings path;
    AmbientOcclusionSettings ambient_occlusion;
    std::vector<Material> materials;
    std::vector<Object> objects;
    std::vector<Light> lights;
};

/// The number of each object within its type of table: 1 for the second [[sphere]], which -D calls sphere.1.
std::vector<std::uint32_t> object_numbers(const SceneDescription& scene);
/// How messages call an object: sphere "ball", or sphere.1 for one without a name; number: object_numbers().
std::string object_label(const Object& object, std::uint32_t number);
/// Of a light: point light "key", or point light.1 for the second [[light]] of the file.
std::string light_label(const SceneDescription& scene, std::size_t light);

/// How many primitives of one kind there are: "spheres", 3.
struct PrimitiveCount {
    std::string kind;
    std::uint64_t count = 0;
};

/// Sizes of a built scene.
struct SceneStats {
    std::uint64_t objects = 0;
    std::uint64_t triangles = 0;
    std::vector<PrimitiveCount> quadrics; ///< every kind, in a fixed order
    std::uint64_t planes = 0;
    std::uint64_t lights = 0;
    std::uint64_t tree_nodes = 0;
    int tree_depth = 0;
    std::string tree_quality; ///< "fast", "high", or empty without triangles
    std::uint64_t bytes = 0;  ///< memory of geometry and trees
    Vec3 bounds_min{0};       ///< bounds of everything finite; min > max if there is nothing
    Vec3 bounds_max{0};
};

namespace scene {
struct SceneData;
}

/// A scene ready for rendering: immutable, cheap to copy, usable by any number of threads.
class Scene {
  public:
    explicit Scene(std::shared_ptr<const scene::SceneData> scene_data) : data_(std::move(scene_data)) {}
    const scene::SceneData& data() const { return *data_; } ///< for the library itself
    SceneStats stats() const;
    const SceneDescription& description() const; ///< as built, with its camera filled in
    const CameraDescription& camera() const;
    bool has_own_camera() const; ///< or one chosen by fit_camera()
    const RenderSettings& render_settings() const;

  private:
    std::shared_ptr<const scene::SceneData> data_;
};

/// May be set by any thread or a signal handler: operations end within milliseconds.
using CancelFlag = std::atomic<bool>;

/// Progress of loading and building a scene.
struct LoadProgress {
    std::string activity; ///< "reading bunny.ply", "building the trees"
    double fraction = 0;  ///< of this activity, 0 … 1
};
/// Called occasionally, by one thread at a time.
using LoadCallback = std::function<void(const LoadProgress&)>;

struct BuildSceneOptions {
    int threads = 0; ///< 0: one for each processor that may be used
    /// Determine which meshes are closed even if no material is transparent, so that update_scene() may make
    /// any material transparent. Takes a pass over all edges and changes no picture.
    bool find_solids = false;
    const CancelFlag* cancel = nullptr; ///< once it is set, Error(cancelled) is thrown
    LoadCallback progress;
};

/// Validates the description, bakes transforms and builds trees. Throws Error(input) with all errors found,
/// and Error(resource) where there is no memory for the trees.
Scene build_scene(const SceneDescription& description, const BuildSceneOptions& options = {});

/// Equivalent to build_scene(description), but faster: if the objects and their transforms are those of
/// `scene`, its trees are shared, whatever changed in materials, lights, camera and settings. Meshes are
/// compared by their data pointers. Everything is rebuilt if objects differ, or if meshes become transparent
/// and `scene` was built without `find_solids`.
Scene update_scene(const Scene& scene, const SceneDescription& description,
                   const BuildSceneOptions& options = {});

/// The scene with another camera and picture size. Throws Error(input) if either is invalid.
Scene with_view(const Scene& scene, const CameraDescription& camera, int width, int height);

/// Warnings about valid but suspicious scenes: no light, camera or light inside an object, open mesh made of
/// glass, coincident glass faces, a material that emits more light than it receives, objects hidden inside
/// glass that owns their space.
std::vector<Diagnostic> warnings(const Scene& scene);

/// Guesses the up axis of a mesh by its shape: y or z.
Axis guess_up_axis(const Mesh& mesh);

/// A preview scene of a mesh: framed, lit, on a floor if wanted, rotated so that `up` points along +z.
/// Throws Error(input) for a mesh without anything to show.
SceneDescription preview_scene(std::shared_ptr<const Mesh> mesh, const std::string& file, Axis up,
                               bool floor = true);
/// The same around an object with a mesh as it stands.
SceneDescription preview_scene(Object mesh, bool floor = true);

/// The camera that shows everything finite in the scene, for a picture of its size.
CameraDescription fit_camera(const SceneDescription& description);

} // namespace glint
