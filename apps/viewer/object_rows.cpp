#include "object_rows.h"

#include "key_rows.h"

#include "glint/document.h"
#include "glint/scene.h"

#include <algorithm>
#include <array>

namespace glint::viewer {
namespace {

/// What a pixel of dragging adds to angles, in degrees.
constexpr double angle_step = 0.5;

std::vector<std::string> material_names(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const Material& material : scene.materials) names.push_back(material.name);
    return names;
}

std::vector<std::string> mesh_names(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const Object& object : scene.objects)
        if (std::holds_alternative<MeshShape>(object.shape) && !object.name.empty())
            names.push_back(object.name);
    return names;
}

Vec3 vector(const std::vector<double>& three) { return {three[0], three[1], three[2]}; }

/// The rows of an object's transform, entry by entry as the file has them.
class TransformRows {
  public:
    TransformRows(Rows& rows, const std::string& table, double step, const FileKeys& keys)
        : rows_(rows), table_(table), step_(step), keys_(keys) {}

    /// `add_move`: can the object be moved by nothing else? Then there is a row for an entry to be.
    void draw(bool add_move) const {
        int count = 0;
        bool moves = false;
        for (; has_entry(count); ++count) moves = draw_entry(entry(count));
        if (!add_move || moves) return;
        // Once it is written, the row is that of the entry: it keeps its name.
        Vec3 way(0);
        if (!rows_.drag(entry(count) + "translate", "move", way, step_, "an entry behind those of the file"))
            return;
        const auto longer =
            keys_.longer_list(table_ + ".transform", "{ translate = " + scene_value(way) + " }");
        if (longer) rows_.set("transform", *longer);
    }

  private:
    static std::string entry(int number) { return "transform." + std::to_string(number) + "."; }
    std::vector<double> numbers(const std::string& key) const { return keys_.numbers(table_ + "." + key); }

    bool has_entry(int number) const {
        constexpr std::array words{"translate", "rotate", "scale", "matrix"};
        return std::any_of(words.begin(), words.end(),
                           [&](const char* word) { return keys_.has(table_ + "." + entry(number) + word); });
    }

    /// Is it one that moves?
    bool draw_entry(const std::string& entry) const {
        const auto move = numbers(entry + "translate");
        const auto axis = numbers(entry + "rotate");
        const auto angle = numbers(entry + "angle");
        if (move.size() == 3)
            rows_.place(entry + "translate", "move", vector(move), step_,
                        "an entry of the transform; they apply in the order of the file");
        if (angle.size() == 1)
            rows_.length(entry + "angle", "turn", angle[0], angle_step,
                         "degrees about the axis, through the origin");
        if (axis.size() == 3)
            rows_.place(entry + "rotate", "axis", vector(axis), share_step, "to turn about; of any length");
        scale_row(rows_, entry + "scale", numbers(entry + "scale"), "about the origin; negative mirrors");
        return move.size() == 3;
    }

    Rows& rows_;
    const std::string& table_;
    double step_;
    const FileKeys& keys_;
};

} // namespace

void object_rows(Ui& ui, const SceneDescription& scene, const Object& object, const std::string& table,
                 double step, const FileKeys& keys, std::vector<Edit>& edits) {
    const TableSpec& spec = description_table(name_of(object.shape));
    KeyRows rows(ui, edits, table, spec, KeyOwner(object), step, keys);
    rows.names("material", material_names(scene));
    rows.row("visible");
    if (is_solid(object.shape)) rows.row("priority");
    for (const KeySpec& key : spec.keys) {
        // The common keys follow the shape's own.
        if (key.key == "name") break;
        if (key.key == "mesh")
            rows.names(key.key, mesh_names(scene));
        else if (key.key != spec.selector)
            rows.row(key);
    }
    const bool has_no_place = std::holds_alternative<MeshShape>(object.shape) ||
                              std::holds_alternative<InstanceShape>(object.shape);
    TransformRows(rows.rows(), table, step, keys).draw(has_no_place);
}

} // namespace glint::viewer
