#include "formats/scene_read.h"

#include "formats/scene_words.h"

#include <algorithm>
#include <numbers>

namespace glint {
namespace {

using Kind = TreeValue::Kind;

void read_camera(TableReader table, CameraDescription& camera) {
    Vec3 look_at = camera.eye + camera.direction;
    table.read("eye", camera.eye);
    table.read("look_at", look_at);
    table.read("direction", camera.direction);
    table.read("up", camera.up);
    table.read("fov", camera.fov);
    table.read_choice("fov_axis", camera.fov_axis);
    if (!table.good()) return;

    if (table.has("look_at")) {
        camera.direction = look_at - camera.eye;
        if (camera.direction == Vec3(0))
            return table.error(table.place("look_at"), "\"look_at\" is where the \"eye\" is",
                               "the camera looks from one to the other");
    }
    // Relative to both lengths: what is left of a cross product of parallel vectors is rounding.
    const Vec3 side = glm::cross(camera.direction, camera.up);
    const double lengths = glm::length(camera.direction) * glm::length(camera.up);
    if (!(glm::length(side) > 1e-12 * lengths))
        table.error(table.has("up") ? table.place("up")
                                    : table.place(table.has("look_at") ? "look_at" : "direction"),
                    "\"up\" is parallel to the view", "choose an up that the camera does not look along");
}

void read_render(TableReader table, RenderSettings& render) {
    table.read_size("size", render.width, render.height);
    table.read("spp", render.spp);
    table.read("seed", render.seed);
    table.read_choice("integrator", render.integrator);
    table.read_choice("filter", render.filter);
    table.read("background", render.background);
}

void read_whitted(TableReader table, WhittedSettings& whitted) {
    table.read("max_depth", whitted.max_depth);
    table.read_choice("shadows", whitted.shadows);
    table.read("clamp", whitted.clamp);
    table.read_choice("energy", whitted.energy);
    table.read_choice("highlight_model", whitted.highlight_model);
    table.read("index", whitted.index);
}

void read_material(TableReader table, Material& material, Problems& problems) {
    table.read("color", material.color);
    table.read("ambient", material.ambient);
    table.read("diffuse", material.diffuse);
    table.read("highlight", material.highlight);
    table.read("shininess", material.shininess);
    table.read("reflectivity", material.reflectivity);
    table.read("transparency", material.transparency);
    table.read("index", material.index);
    table.read("absorption", material.absorption);
    table.read("fresnel", material.fresnel);
    table.read("emission", material.emission);
    if (material.reflectivity > 1 && table.has("reflectivity"))
        problems.warning(table.place("reflectivity"),
                         "\"reflectivity\" " + show(material.reflectivity) + " is above 1",
                         "the mirror image is brighter than what it shows");
}

PlaneShape read_plane(TableReader& table) {
    PlaneShape plane;
    table.read("normal", plane.normal);
    table.read("offset", plane.offset);
    table.read("solid", plane.solid);
    return plane;
}

SphereShape read_sphere(TableReader& table) {
    SphereShape sphere;
    table.read("center", sphere.center);
    table.read("radius", sphere.radius);
    return sphere;
}

CylinderShape read_cylinder(TableReader& table) {
    CylinderShape cylinder;
    table.read("base", cylinder.base);
    table.read("axis", cylinder.axis);
    table.read("height", cylinder.height);
    table.read("radius", cylinder.radius);
    return cylinder;
}

TriangleShape read_triangle(TableReader& table) {
    TriangleShape triangle;
    table.read("vertices", triangle.vertices);
    return triangle;
}

PolyhedronShape read_polyhedron(TableReader& table) {
    PolyhedronShape polyhedron;
    table.read_choice("kind", polyhedron.kind);
    table.read("center", polyhedron.center);
    table.read("size", polyhedron.size);
    table.read("radius", polyhedron.radius);
    table.read("sides", polyhedron.sides);
    table.read("height", polyhedron.height);
    table.read("axis", polyhedron.axis);
    return polyhedron;
}

MeshShape read_mesh(TableReader& table) {
    MeshShape mesh;
    table.read("file", mesh.file);
    table.read("scale", mesh.scale);
    table.read_choice("normals", mesh.normals);
    table.read_choice("facing", mesh.facing);
    table.read_choice("vertex_colors", mesh.vertex_colors);
    table.read("point_radius", mesh.point_radius);
    return mesh;
}

InstanceShape read_instance(TableReader& table) {
    InstanceShape instance;
    table.read("mesh", instance.mesh);
    return instance;
}

Shape read_shape(TableReader& table, std::string_view name) {
    if (name == "plane") return read_plane(table);
    if (name == "sphere") return read_sphere(table);
    if (name == "cylinder") return read_cylinder(table);
    if (name == "triangle") return read_triangle(table);
    if (name == "polyhedron") return read_polyhedron(table);
    if (name == "mesh") return read_mesh(table);
    return read_instance(table);
}

// `intensity`, or `radiant_intensity` in W/sr: Whitted's terms are π times the radiance convention.
void read_intensity(TableReader& table, double& intensity) {
    double radiant = intensity * std::numbers::pi;
    table.read("intensity", intensity);
    table.read("radiant_intensity", radiant);
    if (table.has("radiant_intensity")) intensity = radiant / std::numbers::pi;
}

AmbientLight read_ambient(TableReader& table) {
    AmbientLight light;
    table.read("color", light.color);
    return light;
}

PointLight read_point(TableReader& table) {
    PointLight light;
    table.read("position", light.position);
    table.read("color", light.color);
    read_intensity(table, light.intensity);
    return light;
}

DirectionalLight read_directional(TableReader& table) {
    DirectionalLight light;
    table.read("direction", light.direction);
    table.read("color", light.color);
    table.read("irradiance", light.irradiance);
    return light;
}

SpotLight read_spot(TableReader& table) {
    SpotLight light;
    table.read("position", light.position);
    table.read("direction", light.direction);
    table.read("angle", light.angle);
    table.read("blend", light.blend);
    table.read("color", light.color);
    read_intensity(table, light.intensity);
    return light;
}

// Walks the tree and fills a description.
class SceneReader {
  public:
    SceneReader(const TreeValue& root, Problems& problems, bool patch)
        : root_(root), problems_(problems), context_{problems, ColorValues::srgb, patch} {}

    ReadScene run(SceneDescription start) {
        scene_.description = std::move(start);
        read_root();
        check_tables();
        read_settings();
        read_materials();
        for (const Element& element : elements()) {
            if (element.spec->object)
                read_object(element);
            else
                read_light(element);
        }
        return std::move(scene_);
    }

  private:
    /// A table of [[spec]].
    struct Element {
        const TableSpec* spec;
        const TreeValue* table;
    };

    void read_root() {
        // The tables beside the keys of the top are looked at one by one later.
        TreeValue top;
        top.where = {0, 1, 1};
        for (const TreeEntry& entry : root_.entries)
            if (find_key(*find_table(""), entry.key, {})) top.entries.push_back(entry);
        TableReader table(top, *find_table(""), find_table("")->header(), {}, context_);
        int version = 1;
        table.read("version", version);
        if (version != 1)
            table.error(table.place("version"), "this scene file is of version " + std::to_string(version),
                        "this glint reads version 1");
        table.read_choice("color_values", context_.colors);
    }

    void check_tables() {
        for (const TreeEntry& entry : root_.entries) {
            if (find_key(*find_table(""), entry.key, {})) continue;
            const TableSpec* spec = find_table(entry.key);
            if (!spec || spec->form == TableForm::entry || spec->form == TableForm::root)
                report_unknown(entry);
            else
                check_form(entry, *spec);
        }
    }

    void report_unknown(const TreeEntry& entry) {
        std::vector<std::string> names;
        for (const TableSpec& spec : table_specs())
            if (spec.form != TableForm::root && spec.form != TableForm::entry) names.emplace_back(spec.name);
        for (const std::string& key : key_names(*find_table(""), {})) names.push_back(key);
        const bool table = entry.value.kind == Kind::table || entry.value.kind == Kind::list;
        std::string hint = problems_.suggestion(entry.key, names);
        if (hint.empty()) hint = "expected one of " + listed(names);
        problems_.error(entry.where, (table ? "unknown table " : "unknown key ") + in_quotes(entry.key),
                        std::move(hint));
    }

    void check_form(const TreeEntry& entry, const TableSpec& spec) {
        const Kind expected = spec.form == TableForm::list ? Kind::list : Kind::table;
        if (entry.value.kind != expected) {
            problems_.error(entry.where, in_quotes(entry.key) + " is written as " + spec.header() +
                                             ", found " + std::string(entry.value.kind_words()));
            return;
        }
        for (const TreeValue& item : entry.value.items)
            if (item.kind != Kind::table)
                problems_.error(item.where,
                                "expected a table in " + in_quotes(entry.key) + ", found " +
                                    std::string(item.kind_words()),
                                "write " + spec.header());
        if (spec.form != TableForm::named) return;
        for (const TreeEntry& named : entry.value.entries) {
            if (named.key.empty())
                problems_.error(named.where, "the name of a " + in_quotes(spec.name) + " must not be empty");
            if (named.value.kind != Kind::table)
                problems_.error(named.where, "expected a table " + spec.header() + ", found " +
                                                 std::string(named.value.kind_words()) + " named " +
                                                 in_quotes(named.key));
        }
    }

    const TreeValue* table(std::string_view name) const {
        const TreeEntry* entry = root_.find(name);
        return entry && entry->value.kind == Kind::table ? &entry->value : nullptr;
    }

    TableReader reader(const TreeValue& value, const TableSpec& spec, std::string_view name = {}) const {
        return {value, spec, spec.header(name), selected_type(value, spec), context_};
    }

    void read_settings() {
        SceneDescription& d = scene_.description;
        if (const TreeValue* camera = table("camera")) {
            if (!d.camera) d.camera.emplace();
            d.camera->where = problems_.locate(camera->where);
            read_camera(reader(*camera, *find_table("camera")), *d.camera);
        }
        if (const TreeValue* render = table("render"))
            read_render(reader(*render, *find_table("render")), d.render);
        if (const TreeValue* whitted = table("whitted"))
            read_whitted(reader(*whitted, *find_table("whitted")), d.whitted);
    }

    void read_materials() {
        const TreeValue* materials = table("material");
        if (!materials) return;
        const TableSpec& spec = *find_table("material");
        for (const TreeEntry& entry : materials->entries) {
            if (entry.value.kind != Kind::table) continue;
            const TableReader values = reader(entry.value, spec, entry.key);
            Material& material = material_named(entry.key);
            material.where = problems_.locate(values.header());
            scene_.materials.push_back(values.place("reflectivity"));
            read_material(values, material, problems_);
        }
    }

    /// The material to change when patching, else a new one: TOML itself keeps names unique.
    Material& material_named(const std::string& name) {
        std::vector<Material>& materials = scene_.description.materials;
        if (context_.patch)
            for (Material& material : materials)
                if (material.name == name) return material;
        materials.emplace_back();
        materials.back().name = name;
        return materials.back();
    }

    /// The tables of all lists in the order of the file, which numbers objects and lights.
    std::vector<Element> elements() const {
        std::vector<Element> all;
        for (const TableSpec& spec : table_specs()) {
            const bool placed = spec.object || spec.name == "light";
            const TreeEntry* entry = placed ? root_.find(spec.name) : nullptr;
            if (!entry || entry->value.kind != Kind::list) continue;
            for (const TreeValue& item : entry->value.items)
                if (item.kind == Kind::table) all.push_back({&spec, &item});
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const Element& a, const Element& b) { return a.table->where < b.table->where; });
        return all;
    }

    void read_object(const Element& element) {
        TableReader table = reader(*element.table, *element.spec);
        Object object;
        object.shape = read_shape(table, element.spec->name);
        table.read("name", object.name);
        table.read("material", object.material);
        table.read("visible", object.visible);
        table.read("priority", object.priority);
        if (const TreeValue* list = table.list("transform"))
            object.transform = read_transform(*list, context_);
        object.where = problems_.locate(table.header());

        const auto place_of_shape = [&] {
            for (const char* key : {"vertices", "file", "mesh"})
                if (find_key(*element.spec, key, {})) return table.place(key);
            return table.header();
        };
        scene_.objects.push_back({std::string(element.spec->name), table.header(), table.place("name"),
                                  table.place("material"), place_of_shape(), table.place("transform"),
                                  table.good()});
        scene_.description.objects.push_back(std::move(object));
    }

    void read_light(const Element& element) {
        const std::string type = selected_type(*element.table, *element.spec);
        TableReader table = reader(*element.table, *element.spec);
        Light light;
        light.where = problems_.locate(table.header());
        // The type itself is read to report a wrong one.
        std::string checked;
        table.read_choice("type", checked);
        if (type == "ambient")
            light.kind = read_ambient(table);
        else if (type == "point")
            light.kind = read_point(table);
        else if (type == "directional")
            light.kind = read_directional(table);
        else if (type == "spot")
            light.kind = read_spot(table);
        scene_.description.lights.push_back(light);
    }

    const TreeValue& root_;
    Problems& problems_;
    ReadContext context_;
    ReadScene scene_;
};

} // namespace

ColorValues color_values_of(const TreeValue& root) {
    const TreeEntry* entry = root.find("color_values");
    return entry && entry->value.text == "linear" ? ColorValues::linear : ColorValues::srgb;
}

ReadScene read_scene(const TreeValue& root, Problems& problems) {
    return SceneReader(root, problems, false).run({});
}

void patch_scene(const TreeValue& root, SceneDescription& description, Problems& problems) {
    description = SceneReader(root, problems, true).run(std::move(description)).description;
}

} // namespace glint
