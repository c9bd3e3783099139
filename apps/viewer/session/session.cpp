// The session: passes files, edits and the camera on to its loader, renderer and explainer.
#include "session.h"

#include "glint/pick.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace glint::viewer {

Session::Session(SessionOptions options)
    : options_(std::move(options)), width_(options_.width), height_(options_.height),
      renderer_({options_.threads, options_.first_picture_seconds, options_.changed}),
      explainer_(options_.changed), loader_(loader_options()) {}

SessionLoader::Options Session::loader_options() {
    SessionLoader::Options result;
    result.load = options_.load;
    result.threads = options_.threads;
    result.watch = options_.watch;
    result.loaded = [this](LoadedFile file) { show_file(std::move(file)); };
    result.edited = [this](ViewSlot slot, Scene edited) { show_edit(slot, std::move(edited)); };
    result.changed = options_.changed;
    return result;
}

void Session::set_scene(ViewSlot slot, std::optional<Scene> scene) {
    scenes_[slot] = scene;
    explainer_.set_scene(slot, scene);
    renderer_.set_scene(slot, std::move(scene));
}

// The camera of a file, or one that frames its scene for the shape of the window.
CameraControl Session::home(const Scene& scene) const {
    if (scene.has_own_camera()) return {scene.camera(), target_distance(scene)};
    SceneDescription description = scene.description();
    description.render.width = width_;
    description.render.height = height_;
    const CameraDescription camera = fit_camera(description);
    return {camera, target_distance(with_view(scene, camera, width_, height_))};
}

void Session::show_file(LoadedFile file) {
    const std::lock_guard lock(mutex_);
    const bool keeps_camera = file.is_reload && scene_;
    CameraControl fresh = home(file.scene);
    if (keeps_camera) fresh.set_camera(camera_.camera(), camera_.target_distance());
    camera_ = fresh;
    comparing_ = comparing_ && keeps_camera;
    if (!keeps_camera) explainer_.forget();
    set_scene(ViewSlot::main, file.scene);
    if (!comparing_) set_scene(ViewSlot::reference, std::nullopt);
    scene_ = std::move(file);
    renderer_.set_camera(camera_.camera(), width_, height_);
    if (options_.changed) options_.changed();
}

void Session::show_edit(ViewSlot slot, Scene edited) {
    const std::lock_guard lock(mutex_);
    if (slot == ViewSlot::reference && !comparing_) return;
    if (slot == ViewSlot::main && scene_) scene_->scene = edited;
    set_scene(slot, std::move(edited));
}

std::optional<LoadedFile> Session::scene() const {
    const std::lock_guard lock(mutex_);
    return scene_;
}

void Session::compare(std::optional<SceneDescription> description) {
    {
        const std::lock_guard lock(mutex_);
        comparing_ = description.has_value();
        if (!description) set_scene(ViewSlot::reference, std::nullopt);
    }
    if (description) loader_.edit(ViewSlot::reference, std::move(*description));
}

bool Session::is_comparing() const {
    const std::lock_guard lock(mutex_);
    return comparing_;
}

void Session::set_show(Aov show, ViewSlot slot) {
    if (std::exchange(show_[slot], show) != show) renderer_.set_show(slot, show);
}

void Session::set_kernel(Kernel kernel) {
    if (std::exchange(kernel_, kernel) != kernel) renderer_.set_kernel(kernel);
}

void Session::move(const std::function<void(CameraControl&)>& change) {
    const std::lock_guard lock(mutex_);
    change(camera_);
    renderer_.set_camera(camera_.camera(), width_, height_);
}

namespace {

/// What lies ahead of a point on the way to another, if it is in between.
std::optional<Pick> pick_between(const Scene& scene, const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double distance = glm::length(way);
    if (!(distance > 0)) return std::nullopt;
    const bool steep = std::abs(way.z) > 0.9 * distance;
    const CameraDescription camera{from, way, steep ? Vec3(1, 0, 0) : Vec3(0, 0, 1), 1, FovAxis::y, {}};
    const auto found = pick(with_view(scene, camera, 1, 1), 0.5, 0.5);
    return found && found->distance < distance ? found : std::nullopt;
}

bool is_flat(const Shape& shape) {
    return std::holds_alternative<PlaneShape>(shape) || std::holds_alternative<RectangleShape>(shape) ||
           std::holds_alternative<TriangleShape>(shape) || std::holds_alternative<DiskShape>(shape);
}

} // namespace

void Session::orbit(double right, double up) {
    const std::lock_guard lock(mutex_);
    pick_orbit_target();
    const Vec3 from = camera_.camera().eye;
    camera_.orbit(right, up);
    stay_before_walls(from);
    renderer_.set_camera(camera_.camera(), width_, height_);
}

void Session::stay_before_walls(const Vec3& from) {
    const auto& scene = scenes_[ViewSlot::main];
    if (!scene) return;
    const Vec3 eye = camera_.camera().eye, target = camera_.target();
    const auto wall = pick_between(*scene, from, eye);
    if (!wall) return;
    if (!is_flat(scene->description().objects[wall->object].shape) && !wall->from_inside) return;
    // Where the wall stands between the new eye and the target, or else on the way to the eye.
    constexpr double gap = 0.02; // of the distance to the target
    const auto seen = pick_between(*scene, eye, target);
    const bool slides = seen && seen->object == wall->object;
    const Vec3 point = slides ? seen->position : from;
    camera_.look_from(slides ? point + (target - point) * gap : point);
}

void Session::pick_orbit_target() {
    const auto& scene = scenes_[ViewSlot::main];
    if (camera_.has_picked_target() || !scene) return;
    const Scene seen = with_view(*scene, camera_.camera(), width_, height_);
    const auto hit = pick(seen, width_ / 2.0, height_ / 2.0);
    camera_.set_target(hit ? hit->distance : camera_.target_distance());
}

CameraControl Session::camera() const {
    const std::lock_guard lock(mutex_);
    return camera_;
}

void Session::resize(int width, int height) {
    const std::lock_guard lock(mutex_);
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    if (scene_ && !scene_->scene.has_own_camera() && camera_.is_home()) camera_ = home(scene_->scene);
    renderer_.set_camera(camera_.camera(), width, height);
}

std::optional<Scene> Session::scene_in_view(ViewSlot slot) const {
    const std::lock_guard lock(mutex_);
    const auto& scene = scenes_[slot];
    if (!scene) return std::nullopt;
    return with_view(*scene, camera_.camera(), width_, height_);
}

void Session::explain(ViewSlot slot, int x, int y) {
    const std::lock_guard lock(mutex_);
    explainer_.ask({slot, camera_.camera(), width_, height_, x, y});
}

} // namespace glint::viewer
