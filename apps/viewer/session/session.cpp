// The session: passes files, edits and the camera on to its loader, renderer and explainer.
#include "session.h"

#include "glint/pick.h"

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

void Session::pick_orbit_target() {
    const std::lock_guard lock(mutex_);
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
