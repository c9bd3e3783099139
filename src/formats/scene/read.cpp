// Reading tables into a SceneDescription.

#include "formats/scene/read.h"

#include "glint/scene.h"
#include "scene/framing.h"
#include "scene/keys/check.h"
#include "scene/text.h"

#include <algorithm>
#include <map>
#include <utility>

namespace glint::formats {

using scene::in_quotes;

namespace {

using Kind = TreeValue::Kind;

void read_camera(TableReader table, CameraDescription& camera) {
    table.read(camera);
    if (!table.good()) return;
    if (table.has("look_at") && camera.direction == Vec3(0))
        return table.error(table.position_of("look_at"), "\"look_at\" is where the \"eye\" is",
                           "the camera looks from one to the other");
    const char* view = table.has("look_at") ? "look_at" : "direction";
    if (auto fault = scene::view_fault(camera))
        table.error(table.position_of(table.has("up") ? "up" : view), std::move(fault->message),
                    std::move(fault->hint));
}

// What can be up in a view along a direction, which need not be one.
Vec3 up_beside(const TreeValue& direction) {
    const Vec3 up = CameraDescription().up;
    if (direction.items.size() != 3) return up;
    return scene::up_beside(vec3_of(direction), up);
}

void read_material(TableReader table, Material& material, Problems& problems) {
    table.read(material);
    if (material.reflectivity > 1 && table.has("reflectivity"))
        problems.warning(table.position_of("reflectivity"),
                         "\"reflectivity\" " + scene::show(material.reflectivity) + " is above 1",
                         "the mirror image is brighter than what it shows");
}

template <std::size_t... index>
Shape default_shape(std::string_view name, std::index_sequence<index...>) {
    Shape shape;
    ((name == shape_names[index] ? void(shape.emplace<index>()) : void()), ...);
    return shape;
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
        FileTop read;
        table.read(read);
        if (read.version != 1)
            table.error(table.position_of("version"),
                        "this scene file is of version " + std::to_string(read.version),
                        "this glint reads version 1");
        context_.colors = read.color_values;
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
        std::vector<std::string> names = table_names();
        for (const std::string& key : key_names(*find_table(""), {})) names.push_back(key);
        const bool table = entry.value.kind == Kind::table || entry.value.kind == Kind::list;
        problems_.error(entry.where, (table ? "unknown table " : "unknown key ") + in_quotes(entry.key),
                        problems_.suggestion(entry.key, names, "expected one of " + scene::listed(names)));
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
        for_settings(d, [&](std::string_view name, auto& settings) {
            if (const TreeValue* values = table(name)) reader(*values, *find_table(name)).read(settings);
        });
        if (const TreeValue* whitted = table("whitted"); whitted && whitted->find("energy"))
            d.whitted.energy_chosen = true;
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
            scene_.materials.push_back(values.position_of("reflectivity"));
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
            const bool is_element = spec.object || spec.name == "light";
            const TreeEntry* entry = is_element ? root_.find(spec.name) : nullptr;
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
        Object& object = next_object(element.spec->name);
        table.read(object);
        object.where = problems_.locate(table.header());

        const auto position_of_shape = [&] {
            for (const char* key : {"vertices", "file", "mesh"})
                if (find_key(*element.spec, key, {})) return table.position_of(key);
            return table.header();
        };
        scene_.objects.push_back({std::string(element.spec->name), table.header(), table.position_of("name"),
                                  table.position_of("material"), position_of_shape(),
                                  table.position_of("transform"), table.good()});
    }

    /// When patching, the next object of that type, as the tree has a table for each; else a new one.
    Object& next_object(std::string_view type) {
        std::vector<Object>& objects = scene_.description.objects;
        if (!context_.patch) {
            constexpr auto all = std::make_index_sequence<std::variant_size_v<Shape>>();
            objects.emplace_back().shape = default_shape(type, all);
            return objects.back();
        }
        std::size_t& next = next_[type];
        while (name_of(objects[next].shape) != type) ++next;
        return objects[next++];
    }

    Light& next_light() {
        std::vector<Light>& lights = scene_.description.lights;
        return context_.patch ? lights[next_["light"]++] : lights.emplace_back();
    }

    void read_light(const Element& element) {
        TableReader table = reader(*element.table, *element.spec);
        Light& light = next_light();
        light.where = problems_.locate(table.header());
        // Without a type it is not known which keys it may have.
        if (selected_type(*element.table, *element.spec).empty())
            table.value(*find_key(*element.spec, element.spec->selector, {}));
        else
            table.read(light);
        scene_.lights.push_back(table.position_of("name"));
    }

    const TreeValue& root_;
    Problems& problems_;
    ReadContext context_;
    ReadScene scene_;
    std::map<std::string_view, std::size_t> next_; ///< to patch, by type of table
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

std::optional<TreeValue> taken_camera(TreeValue& root) {
    TreeEntry* entry = root.find("camera");
    if (!entry) return std::nullopt;
    TreeValue camera = std::move(entry->value);
    std::erase_if(root.entries, [](const TreeEntry& e) { return e.key == "camera"; });
    return camera;
}

void patch_framing(const TreeValue& camera, SceneDescription& description, Problems& problems) {
    const auto given = [&](std::string_view key) { return camera.find(key) != nullptr; };
    description.camera = fit_camera(description);
    if (const TreeEntry* direction = camera.find("direction"); direction && !given("up"))
        description.camera->up = up_beside(direction->value);
    TreeValue root;
    root.entries.push_back({"camera", camera.where, camera});
    patch_scene(root, description, problems);

    const CameraDescription& patched = *description.camera;
    if (given("look_at") || (given("eye") && given("direction"))) return;
    if (given("eye")) return scene::look_at_middle(*description.camera, description);
    Framing& framing = description.framing;
    if (given("direction")) framing.direction = patched.direction;
    framing.up = patched.up;
    framing.fov = patched.fov;
    framing.fov_axis = patched.fov_axis;
    description.camera.reset();
}

} // namespace glint::formats
