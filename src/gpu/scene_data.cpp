#include "gpu/scene_data.h"

#include "glint/error.h"
#include "glint/term.h"
#include "render/camera_sampler.h"
#include "trace/world_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace glint {
namespace {

static_assert(static_cast<uint>(Term::ambient) == term_ambient);
static_assert(static_cast<uint>(Term::diffuse) == term_diffuse);
static_assert(static_cast<uint>(Term::highlight) == term_highlight);
static_assert(static_cast<uint>(Term::clamp) == term_clamp);
static_assert(static_cast<uint>(Term::reflection) == term_reflection);
static_assert(static_cast<uint>(Term::transmission) == term_transmission);
static_assert(static_cast<uint>(Term::emission) == term_emission);

constexpr std::uint32_t none = 0xffffffffu;
constexpr std::uint32_t object_solid = 1;
constexpr std::uint32_t object_lit_as_stored = 2;
constexpr std::uint32_t object_turned = 4;
constexpr std::uint32_t object_fresnel = 8;
constexpr std::size_t most_media = 8; ///< around one ray
constexpr std::size_t most_glass = 0xffff;

class Flattener {
  public:
    explicit Flattener(const FrozenScene& scene) : scene_(scene), world_(scene.world.data()) {}

    GpuSceneData run(const GpuTree* tree) {
        data_.tree = tree != nullptr ? *tree : build_gpu_tree(world_);
        data_.glass = scene_.any_transparent;
        add_meshes();
        add_shapes();
        add_media();
        add_objects();
        add_tables();
        add_filter();
        set_scene();
        set_view(data_, scene_);
        return std::move(data_);
    }

  private:
    std::uint32_t words() const { return static_cast<std::uint32_t>(data_.words.size()); }
    std::uint32_t shapes() const { return static_cast<std::uint32_t>(data_.shapes.size()); }

    void add(const dvec3& v) { data_.shapes.insert(data_.shapes.end(), {v.x, v.y, v.z}); }
    void add(const dmat3& m) {
        for (int column = 0; column < 3; ++column) add(m[column]);
    }
    void add(double x) { data_.shapes.push_back(x); }

    /// The number of the first triangle, and the object, of each mesh in the world.
    void add_meshes() {
        for (std::size_t i = 0; i < world_.meshes.size(); ++i) {
            data_.words.push_back(world_.first_numbers[i]);
            data_.words.push_back(world_.meshes[i].object);
        }
        data_.settings.mesh_count = static_cast<std::uint32_t>(world_.meshes.size());
    }

    void add_shapes() {
        for (const NumberedPlane& plane : world_.planes) {
            add(plane.plane.normal);
            add(plane.plane.offset);
            add(plane.object);
        }
        data_.settings.plane_count = static_cast<std::uint32_t>(world_.planes.size());
        data_.settings.first_quadric = shapes();
        for (const Quadric& quadric : world_.quadrics) {
            add(quadric.shape.kind == quadric_sphere ? 2.0 : 3.0); // kind_sphere, kind_cylinder of trace.glsl
            add(quadric.affine);
            add(quadric.object);
            add(quadric.prim);
            add(quadric.shape.base);
            add(quadric.shape.axis);
            add(quadric.shape.height);
            add(quadric.shape.radius);
        }
        data_.settings.first_affine = shapes();
        for (const Affine& affine : world_.affines) {
            add(affine.linear);
            add(affine.inverse);
            add(affine.translation);
        }
        add_instances();
        data_.settings.tree_root = data_.tree.root;
    }

    void add_instances() {
        data_.settings.first_instance = shapes();
        for (std::uint32_t i = 0; i < world_.instances.size(); ++i) {
            const PlacedMesh& placed = world_.instances[i];
            add(world_.instance_tree.inverse(i));
            add(world_.instance_tree.translation(i));
            add(placed.linear);
            add(placed.slack);
            add(placed.object);
            add(placed.turned ? 1.0 : 0.0);
            add(data_.tree.mesh_roots[placed.mesh]);
            add(data_.tree.mesh_corners[placed.mesh]);
        }
    }

    bool is_glass(std::uint32_t object) const {
        const FrozenObject& o = scene_.objects[object];
        return o.solid && scene_.materials[o.material].transparency > 0.0f;
    }

    /// Transparent solids by rank: their numbers there, from 1, are what rays carry.
    void add_media() {
        std::vector<std::uint32_t> glass;
        for (std::uint32_t i = 0; i < scene_.objects.size(); ++i)
            if (is_glass(i)) glass.push_back(i);
        if (glass.size() > most_glass)
            throw Error(ErrorKind::device,
                        "the scene has " + std::to_string(glass.size()) +
                            " transparent solids, and the GPU can tell " + std::to_string(most_glass) +
                            " apart",
                        "render on the CPU");
        std::sort(glass.begin(), glass.end(), [&](std::uint32_t a, std::uint32_t b) {
            return scene_.objects[a].rank < scene_.objects[b].rank;
        });
        data_.settings.first_interior = words();
        media_.assign(scene_.objects.size(), 0);
        for (const std::uint32_t object : glass) {
            data_.words.push_back(object);
            media_[object] = words() - data_.settings.first_interior;
        }
    }

    void add_objects() {
        for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
            const FrozenObject& o = scene_.objects[i];
            std::uint32_t flags = 0;
            if (o.solid) flags |= object_solid;
            if (o.lit_as_stored) flags |= object_lit_as_stored;
            if (o.turned) flags |= object_turned;
            if ((scene_.materials[o.material].flags & material_fresnel) != 0) flags |= object_fresnel;
            data_.objects.emplace_back(o.material, o.rank, flags, media_[i]);
            data_.objects.push_back(attributes_of(o));
        }
    }

    uvec4 attributes_of(const FrozenObject& object) {
        uvec4 at(none);
        if (object.attributes == no_attributes) return at;
        const MeshAttributes& a = scene_.attributes[static_cast<std::size_t>(object.attributes)];
        at.x = place(a.mesh->triangles);
        if (a.normals != nullptr) at.y = place(*a.normals);
        if (a.colored || a.mesh->triangles.empty()) at.z = place(a.mesh->colors);
        if (object.normal_matrix == no_normal_matrix) return at;
        at.w = shapes();
        add(scene_.normal_matrices[static_cast<std::size_t>(object.normal_matrix)]);
        return at;
    }

    /// Where an array of vectors is among the words; those that objects share are laid once.
    template <class Vector>
    std::uint32_t place(const std::vector<Vector>& vectors) {
        if (vectors.empty()) return none;
        const auto [found, is_new] = placed_.try_emplace(vectors.data(), words());
        if (!is_new) return found->second;
        if (data_.words.size() + 3 * vectors.size() >= none)
            throw Error(ErrorKind::device, "the scene's normals and colours take more than 16 GiB",
                        "render on the CPU");
        for (const Vector& v : vectors)
            for (int axis = 0; axis < 3; ++axis) data_.words.push_back(std::bit_cast<std::uint32_t>(v[axis]));
        return found->second;
    }

    void add_tables() {
        for (const MaterialRecord& m : scene_.materials) {
            data_.tables.emplace_back(m.color, m.ambient);
            data_.tables.emplace_back(m.emission, m.diffuse);
            data_.tables.emplace_back(m.absorption, m.highlight);
            data_.tables.emplace_back(m.shininess, m.transparency, m.index, m.reflectivity);
        }
        data_.settings.first_light = static_cast<std::uint32_t>(data_.tables.size());
        for (const LightRecord& l : scene_.lights) {
            data_.tables.emplace_back(l.position, static_cast<float>(l.kind));
            data_.tables.emplace_back(l.direction, l.cos_outer);
            data_.tables.emplace_back(l.strength, l.cos_inner);
        }
        data_.settings.light_count = static_cast<std::uint32_t>(scene_.lights.size());
    }

    void add_filter() {
        GpuSettings& s = data_.settings;
        const CameraSampler sampler(scene_.description);
        const PixelFilterSampler& filter = sampler.filter();
        s.filter_radius = filter.radius();
        s.first_tail = static_cast<std::uint32_t>(data_.tables.size());
        for (const float tail : filter.tails()) data_.tables.emplace_back(tail, 0.0f, 0.0f, 0.0f);
        const RenderSettings& r = scene_.description.render;
        s.seed_low = static_cast<std::uint32_t>(r.seed);
        s.seed_high = static_cast<std::uint32_t>(r.seed >> 32);
        s.filter_steps = static_cast<std::uint32_t>(filter.tails().size() - 1);
        s.negative_filter_steps = static_cast<std::uint32_t>(filter.negative_steps());
        s.samples = static_cast<std::uint32_t>(r.spp);
        s.pixel_step = 1;
    }

    void set_scene() {
        GpuSettings& s = data_.settings;
        const WhittedSettings& w = scene_.description.whitted;
        s.ambient_light = scene_.ambient;
        s.max_coordinate = data_.tree.corner;
        s.background = scene_.background;
        s.instance_slack = world_.instance_tree.slack();
        s.max_depth = static_cast<std::uint32_t>(w.max_depth);
        s.opaque_shadows = w.shadows == Shadows::opaque ? 1 : 0;
        s.clamp_light = w.clamp ? 1 : 0;
        s.balanced_energy = w.energy == Energy::balanced ? 1 : 0;
        s.phong_highlights = w.highlight_model == HighlightModel::phong ? 1 : 0;
    }

    const FrozenScene& scene_;
    const WorldData& world_;
    GpuSceneData data_;
    std::vector<std::uint32_t> media_;            ///< by object
    std::map<const void*, std::uint32_t> placed_; ///< arrays that are among the words
};

/// Highest rank first; camera_media has the lowest first.
uvec4 interiors_at_eye(const GpuSceneData& data, const std::vector<std::uint32_t>& objects) {
    if (objects.size() > most_media)
        throw Error(ErrorKind::device,
                    "the camera is in " + std::to_string(objects.size()) +
                        " transparent solids, and a ray on the GPU can be in " + std::to_string(most_media),
                    "render on the CPU");
    uvec4 media(0u);
    std::size_t place = objects.size();
    for (const std::uint32_t object : objects) {
        --place;
        media[static_cast<int>(place / 2)] |= data.objects[2 * std::size_t{object}].w
                                              << (place % 2 == 0 ? 16 : 0);
    }
    return media;
}

} // namespace

void set_view(GpuSceneData& data, const FrozenScene& scene) {
    GpuSettings& s = data.settings;
    s.interiors_at_eye = interiors_at_eye(data, scene.camera_media);
    const PinholeCamera camera = camera_of(scene.description);
    s.camera_eye = camera.eye;
    s.image_width = camera.width;
    s.camera_forward = camera.forward;
    s.image_height = camera.height;
    s.camera_right = camera.right;
    s.camera_up = camera.up;
    s.index_outside = scene.index_outside;
}

GpuSceneData flatten(const FrozenScene& scene, const GpuTree* tree) { return Flattener(scene).run(tree); }

} // namespace glint
