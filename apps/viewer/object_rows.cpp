#include "object_rows.h"

#include <algorithm>
#include <array>

namespace glint::viewer {
namespace {

/// What a pixel of dragging adds to numbers without a unit, and to angles in degrees.
constexpr double share_step = 0.005;
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

/// The words of an enumeration, in its order.
template <class Kind, std::size_t count>
void choice_of(Rows& rows, const char* key, const char* label, Kind now,
               const std::array<const char*, count>& words, const char* help) {
    rows.choice(key, label, words[static_cast<std::size_t>(now)], {words.begin(), words.end()}, help);
}

Vec3 vector(const std::vector<double>& three) { return {three[0], three[1], three[2]}; }

/// A factor for all directions, or one for each, as the file has it.
void scale_row(Rows& rows, const std::string& key, const std::vector<double>& written, const char* help) {
    if (written.size() == 3)
        rows.place(key, "scale", vector(written), share_step, help);
    else if (written.size() == 1)
        rows.length(key, "scale", written[0], share_step, help);
}

/// The rows of one shape each.
struct ShapeRows {
    Rows& rows;
    const SceneDescription& scene;
    const std::string& table;
    double step;
    const FileKeys& keys;

    void operator()(const PlaneShape& s) const {
        rows.place("normal", "normal", s.normal, share_step, "at right angles to the plane; of any length");
        rows.length("offset", "offset", s.offset, step, "normal · p = offset");
        rows.check("solid", "solid", s.solid, "the half-space behind the normal, not a thin sheet");
    }
    void operator()(const SphereShape& s) const {
        rows.place("center", "center", s.center, step, "");
        rows.length("radius", "radius", s.radius, step, "");
    }
    void operator()(const CylinderShape& s) const {
        rows.place("base", "base", s.base, step, "centre of the bottom disc");
        rows.place("axis", "axis", s.axis, share_step, "the way up; of any length");
        rows.length("height", "height", s.height, step, "");
        rows.length("radius", "radius", s.radius, step, "");
    }
    void operator()(const TriangleShape& s) const {
        constexpr std::array labels{"corner 1", "corner 2", "corner 3"};
        std::array<Vec3, 3> corners = s.vertices;
        bool moved = false;
        for (std::size_t i = 0; i < corners.size(); ++i)
            moved |= rows.drag("vertices." + std::to_string(i), labels[i], corners[i], step, "");
        if (moved)
            rows.set("vertices", "[" + scene_value(corners[0]) + ", " + scene_value(corners[1]) + ", " +
                                     scene_value(corners[2]) + "]");
    }
    void operator()(const PolyhedronShape& s) const {
        rows.place("center", "center", s.center, step, "");
        if (s.kind == PolyhedronKind::box) {
            rows.place("size", "size", s.size, step, "lengths of the edges");
            return;
        }
        rows.length("radius", "radius", s.radius, step, "of the circumscribed sphere");
        if (s.kind != PolyhedronKind::prism && s.kind != PolyhedronKind::pyramid) return;
        rows.whole("sides", "sides", s.sides, 3, std::max(s.sides, 24), "");
        rows.length("height", "height", s.height, step, "");
        rows.place("axis", "axis", s.axis, share_step, "the way up; of any length");
    }
    void operator()(const MeshShape& s) const {
        choice_of(rows, "normals", "normals", s.normals, std::array{"auto", "flat", "smooth"},
                  "the mesh's own, one a triangle, or smooth ones");
        choice_of(rows, "facing", "facing", s.facing, std::array{"viewer", "stored"},
                  "normals turned to the viewer, or as the winding has them");
        choice_of(rows, "vertex_colors", "vertex colors", s.vertex_colors, std::array{"auto", "ignore"},
                  "do stored colours replace the material's?");
        if (s.point_radius)
            rows.length("point_radius", "point radius", *s.point_radius, step, "of each point's sphere");
        const std::vector<double>& written = keys.numbers(table + ".scale");
        scale_row(rows, "scale", written.empty() ? std::vector{1.0} : written,
                  "before the transform; negative mirrors");
    }
    void operator()(const InstanceShape& s) const {
        rows.choice("mesh", "mesh", s.mesh, mesh_names(scene), "which mesh is shown again");
    }
};

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
    Rows rows(ui, edits, table);
    rows.choice("material", "material", object.material, material_names(scene), "");
    rows.check("visible", "visible", object.visible, "hidden ones are gone for all rays");
    if (is_solid(object.shape))
        rows.whole("priority", "priority", object.priority, std::min(object.priority, -8),
                   std::max(object.priority, 8), "where solids overlap, the higher owns the space");
    std::visit(ShapeRows{rows, scene, table, step, keys}, object.shape);
    const bool has_no_place = std::holds_alternative<MeshShape>(object.shape) ||
                              std::holds_alternative<InstanceShape>(object.shape);
    TransformRows(rows, table, step, keys).draw(has_no_place);
}

} // namespace glint::viewer
