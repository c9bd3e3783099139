#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace glint {
namespace {

constexpr double number_limit = std::numeric_limits<float>::max();

class Checker {
  public:
    explicit Checker(const SceneDescription& description) : scene_(description) {}

    std::vector<Diagnostic> run(Shapes shapes) {
        check_settings();
        if (scene_.camera) check_camera(*scene_.camera);
        for (const Material& material : scene_.materials) check_material(material);
        for (const Object& object : scene_.objects) check_object(object, shapes);
        for (const Light& light : scene_.lights) check_light(light);
        return std::move(found_);
    }

  private:
    void fail(const Location& where, std::string message, std::string hint = {}) {
        found_.push_back({Severity::error, where, std::move(message), std::move(hint), {}});
    }
    void require(bool good, const Location& where, const char* message, const char* hint) {
        if (!good) fail(where, message, hint);
    }
    void require_place(const Vec3& p, const Location& where, const char* what) {
        const bool good = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
                          glm::max(glm::max(std::abs(p.x), std::abs(p.y)), std::abs(p.z)) <= coordinate_limit;
        if (!good) fail(where, std::string(what) + " is not a place", "coordinates go up to 1e12 either way");
    }
    void require_direction(const Vec3& d, const Location& where, const char* what) {
        const double squared = glm::dot(d, d);
        const bool good = std::isfinite(squared) && squared > 0;
        if (!good)
            fail(where, std::string(what) + " has no direction", "expected a finite vector other than 0");
    }
    void require_positive(double x, const Location& where, const char* what) {
        const bool good = std::isfinite(x) && x > 0 && x <= coordinate_limit;
        if (!good) fail(where, std::string(what) + " must be above 0", "expected a finite number up to 1e12");
    }
    void require_not_negative(double x, const Location& where, const char* what) {
        if (!(x >= 0))
            fail(where, std::string(what) + " must not be negative", "expected a finite number from 0");
        if (x > number_limit) fail(where, std::string(what) + " is too large", "numbers go up to 3.4e38");
    }
    void require_index(double x, const Location& where) {
        require_positive(x, where, "index");
        require(!(x > 0) || x >= std::numeric_limits<float>::min(), where, "index is too small",
                "indices of refraction lie near 1");
    }
    // What lights are frozen to must be finite as well.
    void require_strength(const Vec3& color, double intensity, const Location& where) {
        for (int i = 0; i < 3; ++i)
            if (color[i] <= number_limit && intensity <= number_limit)
                require(color[i] * intensity <= number_limit, where, "the light is too strong",
                        "color times intensity goes up to 3.4e38");
    }
    void require_color(const Vec3& c, const Location& where, const char* what) {
        for (int i = 0; i < 3; ++i) require_not_negative(c[i], where, what);
    }

    void check_settings() {
        const RenderSettings& r = scene_.render;
        const bool sides =
            r.width >= 1 && r.height >= 1 && r.width <= picture_side_limit && r.height <= picture_side_limit;
        const bool fits = sides && std::int64_t{r.width} * r.height <= picture_pixel_limit;
        require(fits, {}, "the picture's size is out of range",
                "a side has 1 to 65536 pixels, the whole 2^30");
        require(r.spp >= 1 && r.spp <= (1 << 20), {}, "spp is out of range", "expected 1 to 1048576");
        if (r.integrator != "whitted")
            fail({}, "unknown integrator \"" + r.integrator + "\"", "expected \"whitted\"");
        require_color(r.background, {}, "background");
        const WhittedSettings& w = scene_.whitted;
        require(w.max_depth >= 0 && w.max_depth <= 1000, {}, "max_depth is out of range",
                "expected 0 to 1000");
        require_index(w.index, {});
    }

    void check_camera(const CameraDescription& camera) {
        require_place(camera.eye, camera.where, "eye");
        require_direction(camera.direction, camera.where, "the camera's direction");
        require_direction(camera.up, camera.where, "up");
        const Vec3 side = glm::cross(camera.direction, camera.up);
        const double scale = glm::dot(camera.direction, camera.direction) * glm::dot(camera.up, camera.up);
        require(glm::dot(side, side) > 1e-24 * scale, camera.where, "up is parallel to the view",
                "choose an up that the camera does not look along");
        require(camera.fov > 0 && camera.fov < 180, camera.where, "fov is out of range",
                "expected degrees above 0 and below 180");
    }

    void check_material(const Material& m) {
        require_color(m.color, m.where, "color");
        require_color(m.absorption, m.where, "absorption");
        require_color(m.emission, m.where, "emission");
        require_not_negative(m.ambient, m.where, "ambient");
        require_not_negative(m.diffuse, m.where, "diffuse");
        require_not_negative(m.highlight, m.where, "highlight");
        require_not_negative(m.shininess, m.where, "shininess");
        require_not_negative(m.reflectivity, m.where, "reflectivity");
        require(m.transparency >= 0 && m.transparency <= 1, m.where, "transparency is out of range",
                "expected 0 to 1");
        require_index(m.index, m.where);
        if (scene_.whitted.energy == Energy::balanced && m.reflectivity + m.transparency > 1)
            fail(m.where, "material \"" + m.name + "\" reflects and transmits more than it gets",
                 "energy = \"balanced\" needs reflectivity + transparency <= 1");
    }

    void check_object(const Object& object, Shapes shapes) {
        if (material_of(scene_, object) == nullptr) fail_material(object);
        if (shapes == Shapes::checked) return;
        check_transform(object);
        std::visit([&](const auto& shape) { check_shape(shape, object); }, object.shape);
    }

    void fail_material(const Object& object) {
        std::vector<std::string> names;
        for (const Material& m : scene_.materials) names.push_back(m.name);
        const auto near = nearest_name(object.material, names);
        fail(object.where, "unknown material \"" + object.material + "\"",
             near ? "did you mean \"" + *near + "\"?" : "define it as [material." + object.material + "]");
    }

    void check_transform(const Object& object) {
        const Mat4& m = object.transform;
        bool finite = true;
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) finite = finite && std::isfinite(m[c][r]);
        const bool affine = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
        const double det = glm::determinant(glm::dmat3(m));
        require(finite && affine && std::isfinite(det) && det != 0, object.where,
                "the transform is not affine and regular", "expected a last row 0 0 0 1 and no scale of 0");
    }

    void check_shape(const PlaneShape& s, const Object& o) {
        require_direction(s.normal, o.where, "normal");
        require(std::isfinite(s.offset), o.where, "offset is not a number", "expected a finite number");
    }
    void check_shape(const SphereShape& s, const Object& o) {
        require_place(s.center, o.where, "center");
        require_positive(s.radius, o.where, "radius");
    }
    void check_shape(const CylinderShape& s, const Object& o) {
        require_place(s.base, o.where, "base");
        require_direction(s.axis, o.where, "axis");
        require_positive(s.height, o.where, "height");
        require_positive(s.radius, o.where, "radius");
    }
    void check_shape(const TriangleShape& s, const Object& o) {
        for (const Vec3& p : s.vertices) require_place(p, o.where, "a vertex");
        const Vec3 n = glm::cross(s.vertices[1] - s.vertices[0], s.vertices[2] - s.vertices[0]);
        require(glm::dot(n, n) != 0, o.where, "the triangle is degenerate", "its vertices lie on one line");
    }
    void check_shape(const PolyhedronShape& s, const Object& o) {
        require_place(s.center, o.where, "center");
        for (int i = 0; i < 3; ++i) require_positive(s.size[i], o.where, "size");
        require_positive(s.radius, o.where, "radius");
        require_positive(s.height, o.where, "height");
        require_direction(s.axis, o.where, "axis");
        require(s.sides >= 3 && s.sides <= 65536, o.where, "sides is out of range", "expected 3 to 65536");
    }
    void check_shape(const MeshShape& s, const Object& o) {
        require(s.data != nullptr, o.where, "the mesh is not loaded",
                "load_scene() does, or set MeshShape::data");
        for (int i = 0; i < 3; ++i)
            require(std::isfinite(s.scale[i]) && s.scale[i] != 0, o.where, "scale is 0",
                    "expected other numbers");
        if (s.point_radius) require_positive(*s.point_radius, o.where, "point_radius");
        if (s.data != nullptr) check_indices(*s.data, o);
    }
    void check_shape(const InstanceShape& s, const Object& o) {
        require(find_mesh(scene_, s.mesh) != nullptr, o.where, "the instance names no mesh of the scene",
                "give the mesh a name and use that");
    }
    void check_indices(const Mesh& mesh, const Object& o) {
        glm::uint highest = 0;
        for (const glm::uvec3& t : mesh.triangles)
            highest = glm::max(highest, glm::max(t.x, glm::max(t.y, t.z)));
        const bool inside = mesh.triangles.empty() || highest < mesh.positions.size();
        require(inside, o.where, "a vertex index of the mesh is out of range", "indices count from 0");
        const std::size_t vertices = mesh.positions.size();
        require((mesh.normals.empty() || mesh.normals.size() == vertices) &&
                    (mesh.colors.empty() || mesh.colors.size() == vertices),
                o.where, "the mesh has not one normal and one colour a vertex",
                "as many as positions, or none");
        require(!inside || has_places(mesh), o.where, "a vertex of the mesh is not a place",
                "coordinates of what is shown must be finite");
    }
    // Vertices that no face uses do not matter.
    static bool has_places(const Mesh& mesh) {
        const auto is_place = [](const glm::vec3& p) {
            return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
        };
        if (mesh.triangles.empty())
            return std::all_of(mesh.positions.begin(), mesh.positions.end(), is_place);
        return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
            return is_place(mesh.positions[t.x]) && is_place(mesh.positions[t.y]) &&
                   is_place(mesh.positions[t.z]);
        });
    }

    void check_light(const Light& light) {
        std::visit([&](const auto& kind) { check_kind(kind, light.where); }, light.kind);
    }
    void check_kind(const AmbientLight& l, const Location& where) { require_color(l.color, where, "color"); }
    void check_kind(const PointLight& l, const Location& where) {
        require_place(l.position, where, "position");
        require_color(l.color, where, "color");
        require_not_negative(l.intensity, where, "intensity");
        require_strength(l.color, l.intensity, where);
    }
    void check_kind(const DirectionalLight& l, const Location& where) {
        require_direction(l.direction, where, "direction");
        require_color(l.color, where, "color");
        require_not_negative(l.irradiance, where, "irradiance");
        require_strength(l.color, l.irradiance, where);
    }
    void check_kind(const SpotLight& l, const Location& where) {
        require_place(l.position, where, "position");
        require_direction(l.direction, where, "direction");
        require_color(l.color, where, "color");
        require_not_negative(l.intensity, where, "intensity");
        require_strength(l.color, l.intensity, where);
        require(l.angle > 0 && l.angle <= 90, where, "angle is out of range", "expected degrees up to 90");
        require(l.blend >= 0 && l.blend <= 1, where, "blend is out of range", "expected 0 to 1");
    }

    const SceneDescription& scene_;
    std::vector<Diagnostic> found_;
};

} // namespace

std::vector<Diagnostic> find_errors(const SceneDescription& description, Shapes shapes) {
    return Checker(description).run(shapes);
}

const Object* find_mesh(const SceneDescription& description, const std::string& name) {
    for (const Object& object : description.objects)
        if (object.name == name && std::holds_alternative<MeshShape>(object.shape)) return &object;
    return nullptr;
}

const Material* material_of(const SceneDescription& description, const Object& object) {
    std::string name = object.material;
    if (const auto* instance = std::get_if<InstanceShape>(&object.shape); instance && name.empty()) {
        const Object* mesh = find_mesh(description, instance->mesh);
        if (mesh != nullptr) name = mesh->material;
    }
    for (const Material& m : description.materials)
        if (m.name == name) return &m;
    return nullptr;
}

} // namespace glint
