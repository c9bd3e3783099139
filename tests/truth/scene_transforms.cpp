#include "scene_transforms.h"

#include <cmath>

namespace glint {
namespace {

struct Scaler {
    double s;

    void operator()(PlaneShape& p) const { p.offset *= s; }
    void operator()(SphereShape& p) const {
        p.center *= s;
        p.radius *= s;
    }
    void operator()(CylinderShape& p) const {
        p.base *= s;
        p.height *= s;
        p.radius *= s;
    }
    void operator()(DiskShape& p) const {
        p.center *= s;
        p.radius *= s;
    }
    void operator()(ConeShape& p) const {
        p.base *= s;
        p.height *= s;
        p.radius *= s;
    }
    void operator()(RectangleShape& p) const {
        p.corner *= s;
        p.u *= s;
        p.v *= s;
    }
    void operator()(TriangleShape& p) const {
        for (Vec3& v : p.vertices) v *= s;
    }
    void operator()(PolyhedronShape& p) const {
        p.center *= s;
        p.size *= s;
        p.radius *= s;
        p.height *= s;
    }
    void operator()(MeshShape& p) const {
        // The radius of points is stretched by the scale as well.
        p.scale *= s;
    }
    void operator()(InstanceShape&) const {} // its mesh is scaled
    void operator()(AmbientLight&) const {}
    void operator()(DirectionalLight&) const {}
    void operator()(PointLight& l) const {
        l.position *= s;
        l.intensity *= s * s;
    }
    void operator()(SpotLight& l) const {
        l.position *= s;
        l.intensity *= s * s;
    }
};

Vec3 turned(const Mat4& m, const Vec3& d) { return Vec3(m * glm::dvec4(d, 0)); }
Vec3 carried(const Mat4& m, const Vec3& p) { return Vec3(m * glm::dvec4(p, 1)); }

struct Mover {
    const Mat4& m;

    void operator()(AmbientLight&) const {}
    void operator()(PointLight& l) const { l.position = carried(m, l.position); }
    void operator()(DirectionalLight& l) const { l.direction = turned(m, l.direction); }
    void operator()(SpotLight& l) const {
        l.position = carried(m, l.position);
        l.direction = turned(m, l.direction);
    }
};

void move_object(Object& object, const Mat4& m) {
    // An instance stands on a mesh that is moved as well.
    if (std::holds_alternative<InstanceShape>(object.shape)) {
        object.transform = m * object.transform * glm::inverse(m);
        return;
    }
    auto* plane = std::get_if<PlaneShape>(&object.shape);
    if (plane == nullptr || object.transform != Mat4(1.0)) {
        object.transform = m * object.transform;
        return;
    }
    plane->normal = turned(m, plane->normal);
    plane->offset += glm::dot(plane->normal, Vec3(m[3]));
}

} // namespace

SceneDescription scaled(SceneDescription scene, int k) {
    const double s = std::ldexp(1.0, k);
    scene.camera->eye *= s;
    for (Material& m : scene.materials) m.absorption /= s;
    for (Object& object : scene.objects) {
        std::visit(Scaler{s}, object.shape);
        for (int i = 0; i < 3; ++i) object.transform[3][i] *= s;
    }
    for (Light& light : scene.lights) std::visit(Scaler{s}, light.kind);
    return scene;
}

SceneDescription moved(SceneDescription scene, const Mat4& motion) {
    scene.camera->eye = carried(motion, scene.camera->eye);
    scene.camera->direction = turned(motion, scene.camera->direction);
    scene.camera->up = turned(motion, scene.camera->up);
    for (Object& object : scene.objects) move_object(object, motion);
    for (Light& light : scene.lights) std::visit(Mover{motion}, light.kind);
    return scene;
}

Mat4 mirror_x() {
    Mat4 m(1.0);
    m[0][0] = -1;
    return m;
}

Mat4 swap_xy() {
    Mat4 m(1.0);
    m[0] = {0, 1, 0, 0};
    m[1] = {1, 0, 0, 0};
    return m;
}

} // namespace glint
