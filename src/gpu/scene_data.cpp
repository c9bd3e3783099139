#include "gpu/scene_data.h"

#include "glint/error.h"
#include "glint/term.h"
#include "gpu/interiors.shared.h"
#include "render/camera_sampler.h"
#include "render/interior_list.h"
#include "trace/world/data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace glint::gpu {

using scene::SceneData;
using trace::Affine;
using trace::InstanceData;
using trace::PlanePrim;
using trace::Quadric;
using trace::WorldData;
using trace::WorldInput;
namespace {

static_assert(static_cast<uint>(Term::ambient) == term_ambient);
static_assert(static_cast<uint>(Term::diffuse) == term_diffuse);
static_assert(static_cast<uint>(Term::highlight) == term_highlight);
static_assert(static_cast<uint>(Term::clamp) == term_clamp);
static_assert(static_cast<uint>(Term::reflection) == term_reflection);
static_assert(static_cast<uint>(Term::transmission) == term_transmission);
static_assert(static_cast<uint>(Term::emission) == term_emission);

constexpr std::size_t max_transparent_solids = 0xffff;

class Flattener {
  public:
    explicit Flattener(const SceneData& scene) : scene_(scene), world_(scene.world.data()) {}

    GpuSceneData run(const GpuTree* tree) {
        data_.tree = tree != nullptr ? *tree : build_gpu_tree(world_);
        data_.glass = scene_.any_transparent;
        data_.contacts = scene_.any_contact;
        add_meshes();
        add_shapes();
        add_objects();
        data_.lights = scene_.lights;
        data_.settings.light_count = static_cast<std::uint32_t>(scene_.lights.size());
        set_film();
        set_scene();
        set_view(data_, scene_);
        return std::move(data_);
    }

  private:
    std::uint32_t words() const { return static_cast<std::uint32_t>(data_.words.size()); }

    /// The first triangle's number, and the object, of each mesh in the world's own space: for all in
    /// mesh_tree, then for all in wide_tree.
    void add_meshes() {
        const auto first_wide = static_cast<std::uint32_t>(world_.mesh_tree.triangles);
        for (const bool wide : {false, true})
            for (std::size_t i = 0; i < world_.meshes.size(); ++i) {
                data_.words.push_back(wide ? first_wide + world_.wide_numbers[i] : world_.first_numbers[i]);
                data_.words.push_back(world_.meshes[i].object);
            }
        data_.settings.mesh_count = static_cast<std::uint32_t>(2 * world_.meshes.size());
        data_.settings.first_wide_leaf = data_.tree.first_wide_leaf;
    }

    void add_shapes() {
        for (const PlanePrim& plane : world_.planes) {
            ShapeRecord record{};
            record.object = plane.object;
            record.axis = plane.plane.normal;
            record.height = plane.plane.offset;
            data_.shapes.push_back(record);
        }
        data_.settings.plane_count = static_cast<std::uint32_t>(world_.planes.size());
        for (const Quadric& quadric : world_.quadrics)
            data_.shapes.push_back({quadric.shape.kind, quadric.object, quadric.prim,
                                    quadric.affine < 0 ? 0u : 1u, quadric.shape.base, quadric.shape.axis,
                                    quadric.shape.height, quadric.shape.radius});
        data_.settings.tree_root = data_.tree.root;
    }

    /// Numbers the transparent solids by rank, from 1: these numbers are what rays carry. An object of no
    /// rank stands for the outside.
    void number_interiors() {
        std::vector<std::uint32_t> solids;
        for (std::uint32_t i = 0; i < scene_.objects.size(); ++i)
            if (rendering::is_dielectric(i, scene_)) solids.push_back(i);
        if (solids.size() > max_transparent_solids)
            throw Error(ErrorKind::device,
                        "the scene has " + std::to_string(solids.size()) +
                            " transparent solids, and the GPU can tell " +
                            std::to_string(max_transparent_solids) + " apart",
                        "render on the CPU");
        std::sort(solids.begin(), solids.end(), [&](std::uint32_t a, std::uint32_t b) {
            return scene_.objects[a].rank < scene_.objects[b].rank;
        });
        data_.settings.first_interior = words();
        data_.words.push_back(static_cast<std::uint32_t>(data_.objects.size()));
        data_.objects.emplace_back().material.index = scene_.index_outside;
        data_.interiors.assign(scene_.objects.size(), 0);
        for (const std::uint32_t object : solids) {
            data_.interiors[object] = words() - data_.settings.first_interior;
            data_.words.push_back(object);
            data_.objects[object].interior = data_.interiors[object];
        }
    }

    void add_objects() {
        for (const scene::ObjectData& o : scene_.objects) {
            ObjectRecord record{};
            record.material = scene_.materials[o.material];
            record.rank = o.rank;
            record.contact_low = o.contact.box.lo;
            record.contact_high = o.contact.box.hi;
            record.contact_apart = o.contact.apart;
            record.contact_reach = o.contact.reach;
            if (o.lit_as_stored) record.flags |= object_lit_as_stored;
            if (o.turned) record.flags |= object_turned;
            data_.objects.push_back(record);
        }
        for (std::size_t i = 0; i < world_.meshes.size(); ++i) {
            ObjectRecord& record = data_.objects[world_.meshes[i].object];
            if (world_.meshes[i].flip) record.flags |= object_reversed;
            record.off_edges = world_.off_edges[i];
        }
        for (const Quadric& quadric : world_.quadrics)
            if (quadric.affine >= 0)
                set_local_space(data_.objects[quadric.object],
                                world_.affines[static_cast<std::size_t>(quadric.affine)]);
        for (std::uint32_t i = 0; i < world_.instances.size(); ++i) add_instance(i);
        number_interiors();
        for (std::size_t i = 0; i < scene_.objects.size(); ++i)
            add_attributes(scene_.objects[i], data_.objects[i]);
    }

    /// All quadrics of an object share it.
    static void set_local_space(ObjectRecord& record, const Affine& affine) {
        record.linear = affine.linear;
        record.inverse = affine.inverse;
        record.translation = affine.translation;
    }

    void add_instance(std::uint32_t i) {
        const InstanceData& placed = world_.instances[i];
        ObjectRecord& record = data_.objects[placed.object];
        set_local_space(
            record, {placed.linear, world_.instance_tree.inverse(i), world_.instance_tree.translation(i)});
        record.flags |= object_instance;
        if (placed.turned) record.flags |= object_reversed;
        record.slack = placed.slack;
        record.off_edges = world_.shared_meshes[placed.mesh].off_edges;
        record.mesh_root = data_.tree.mesh_roots[placed.mesh];
        record.mesh_max_coordinate = data_.tree.mesh_max_coordinates[placed.mesh];
    }

    void add_attributes(const scene::ObjectData& object, ObjectRecord& record) {
        record.corners = record.normals = record.colors = invalid_index;
        if (object.attributes == scene::no_attributes) return;
        const scene::MeshAttributes& a = scene_.attributes[static_cast<std::size_t>(object.attributes)];
        record.corners = add_array(a.mesh->triangles);
        if (a.normals != nullptr) record.normals = add_array(*a.normals);
        if (a.colored || a.mesh->triangles.empty()) record.colors = add_array(a.mesh->colors);
        if (object.normal_matrix == scene::no_normal_matrix) return;
        record.flags |= object_local_normals;
        record.normal_matrix = scene_.normal_matrices[static_cast<std::size_t>(object.normal_matrix)];
    }

    /// Index of an array of vectors in the words; arrays that objects share are stored once.
    template <class Vector>
    std::uint32_t add_array(const std::vector<Vector>& vectors) {
        if (vectors.empty()) return invalid_index;
        const auto [found, is_new] = arrays_.try_emplace(vectors.data(), words());
        if (!is_new) return found->second;
        if (data_.words.size() + 3 * vectors.size() >= invalid_index)
            throw Error(ErrorKind::device, "the scene's normals and colours take more than 16 GiB",
                        "render on the CPU");
        for (const Vector& v : vectors)
            for (int axis = 0; axis < 3; ++axis) data_.words.push_back(std::bit_cast<std::uint32_t>(v[axis]));
        return found->second;
    }

    void set_film() {
        GpuSettings& s = data_.settings;
        const rendering::CameraSampler sampler(scene_.description);
        const imaging::PixelFilterSampler& filter = sampler.filter();
        std::copy(filter.tails().begin(), filter.tails().end(), data_.filter_table.tails);
        s.filter_radius = filter.radius();
        s.negative_filter_steps = static_cast<std::uint32_t>(filter.negative_steps());
        const RenderSettings& r = scene_.description.render;
        s.seed_low = static_cast<std::uint32_t>(r.seed);
        s.seed_high = static_cast<std::uint32_t>(r.seed >> 32);
        s.samples = static_cast<std::uint32_t>(sample_counts(r).all);
        s.pixel_step = 1;
    }

    void set_scene() {
        GpuSettings& s = data_.settings;
        const WhittedSettings& w = scene_.description.whitted;
        s.ambient_light = scene_.ambient;
        s.max_coordinate = data_.tree.max_coordinate;
        s.background = scene_.background;
        s.instance_slack = world_.instance_tree.slack();
        s.max_depth = static_cast<std::uint32_t>(w.max_depth);
        s.min_weight = static_cast<float>(w.min_weight);
        s.modes = scene::whitted_modes(w);
    }

    const SceneData& scene_;
    const WorldData& world_;
    GpuSceneData data_;
    std::map<const void*, std::uint32_t> arrays_; ///< indices in the words
};

/// The list of the solids around the eye.
uvec4 interiors_at_eye(const GpuSceneData& data, const std::vector<std::uint32_t>& objects) {
    if (objects.size() > std::size_t{max_interiors})
        throw Error(ErrorKind::device,
                    "the camera is in " + std::to_string(objects.size()) +
                        " transparent solids, and a ray on the GPU can be in " +
                        std::to_string(max_interiors),
                    "render on the CPU");
    uvec4 interiors(0u);
    for (const std::uint32_t object : objects) interiors = interiors_with(interiors, data.interiors[object]);
    return interiors;
}

} // namespace

void set_view(GpuSceneData& data, const SceneData& scene) {
    GpuSettings& s = data.settings;
    s.interiors_at_eye = interiors_at_eye(data, scene.camera_interiors);
    const PinholeCamera camera = rendering::camera_of(scene.description);
    s.camera_eye = camera.eye;
    s.image_width = camera.width;
    s.camera_forward = camera.forward;
    s.image_height = camera.height;
    s.camera_right = camera.right;
    s.camera_up = camera.up;
}

GpuSceneData flatten(const SceneData& scene, const GpuTree* tree) { return Flattener(scene).run(tree); }

} // namespace glint::gpu
