// The session: passes files, edits and the camera on to its loader, renderer and explainer.
#include "session.h"

#include <mutex>
#include <utility>

namespace glint::viewer {

struct Session::State {
    explicit State(SessionOptions given)
        : options(std::move(given)), width(options.width), height(options.height),
          renderer({options.threads, options.first_picture_seconds, options.changed}),
          explainer(options.changed), loader(loader_options()) {}

    SessionLoader::Options loader_options() {
        SessionLoader::Options result;
        result.load = options.load;
        result.threads = options.threads;
        result.watch = options.watch;
        result.loaded = [this](LoadedFile file) { show_file(std::move(file)); };
        result.edited = [this](ViewSlot slot, Scene edited) { show_edit(slot, std::move(edited)); };
        result.changed = options.changed;
        return result;
    }

    const SessionOptions options;

    mutable std::mutex mutex;
    // Guarded by `mutex`.
    std::optional<SessionScene> scene;
    PerView<std::optional<Scene>> scenes; ///< as edited
    PerView<Aov> show;
    Kernel kernel = Kernel::automatic;
    bool comparing = false;
    CameraControl camera;
    int width;
    int height;

    // Thread-safe. Last, so that they end first: their threads call back.
    SessionRenderer renderer;
    SessionExplainer explainer;
    SessionLoader loader;

    // Called on the loader's thread.
    void show_file(LoadedFile file);
    void show_edit(ViewSlot slot, Scene edited);

    /// With `mutex` held.
    void set_scene(ViewSlot slot, std::optional<Scene> wanted) {
        scenes[slot] = wanted;
        explainer.set_scene(slot, wanted);
        renderer.set_scene(slot, std::move(wanted));
    }
};

void Session::State::show_file(LoadedFile file) {
    const std::lock_guard lock(mutex);
    const bool keeps_camera = file.is_reload && scene;
    const double distance = target_distance(file.scene);
    CameraControl fresh(file.scene.camera(), distance);
    if (keeps_camera) fresh.set_camera(camera.camera(), camera.target_distance());
    camera = fresh;
    const std::uint64_t loads = scene ? scene->loads + 1 : 1;
    scene = SessionScene{std::move(file.path), file.scene, std::move(file.warnings), std::move(file.notes),
                         loads};
    comparing = comparing && keeps_camera;
    if (!keeps_camera) explainer.forget();
    set_scene(ViewSlot::main, file.scene);
    if (!comparing) set_scene(ViewSlot::reference, std::nullopt);
    renderer.set_camera(camera.camera(), width, height);
    if (options.changed) options.changed();
}

void Session::State::show_edit(ViewSlot slot, Scene edited) {
    const std::lock_guard lock(mutex);
    if (slot == ViewSlot::reference && !comparing) return;
    if (slot == ViewSlot::main && scene) scene->scene = edited;
    set_scene(slot, std::move(edited));
}

Session::Session(SessionOptions options) : state_(std::make_unique<State>(std::move(options))) {}
Session::~Session() = default;

void Session::open(const std::string& path) { state_->loader.open(path); }
void Session::reload() { state_->loader.reload(); }
void Session::cancel_loading() { state_->loader.cancel(); }
LoadStatus Session::load_status() const { return state_->loader.status(); }

std::optional<SessionScene> Session::scene() const {
    const std::lock_guard lock(state_->mutex);
    return state_->scene;
}

void Session::edit(SceneDescription description) {
    state_->loader.edit(ViewSlot::main, std::move(description));
}

void Session::compare(std::optional<SceneDescription> description) {
    {
        const std::lock_guard lock(state_->mutex);
        state_->comparing = description.has_value();
        if (!description) state_->set_scene(ViewSlot::reference, std::nullopt);
    }
    if (description) state_->loader.edit(ViewSlot::reference, std::move(*description));
}

bool Session::is_comparing() const {
    const std::lock_guard lock(state_->mutex);
    return state_->comparing;
}

void Session::set_show(Aov show, ViewSlot slot) {
    const std::lock_guard lock(state_->mutex);
    if (state_->show[slot] == show) return;
    state_->show[slot] = show;
    state_->renderer.set_show(slot, show);
}

void Session::set_kernel(Kernel kernel) {
    const std::lock_guard lock(state_->mutex);
    if (state_->kernel == kernel) return;
    state_->kernel = kernel;
    state_->renderer.set_kernel(kernel);
}

Kernel Session::kernel() const {
    const std::lock_guard lock(state_->mutex);
    return state_->kernel;
}

void Session::set_tone(View tone) { state_->renderer.set_tone(tone); }

Aov Session::show(ViewSlot slot) const {
    const std::lock_guard lock(state_->mutex);
    return state_->show[slot];
}

void Session::set_backend(BackendFactory gpu) { state_->renderer.set_backend(std::move(gpu)); }

void Session::move(const std::function<void(CameraControl&)>& change) {
    const std::lock_guard lock(state_->mutex);
    change(state_->camera);
    state_->renderer.set_camera(state_->camera.camera(), state_->width, state_->height);
}

void Session::pick_orbit_target() {
    const std::lock_guard lock(state_->mutex);
    CameraControl& camera = state_->camera;
    const auto& scene = state_->scenes[ViewSlot::main];
    if (camera.has_picked_target() || !scene) return;
    const Scene seen = with_view(*scene, camera.camera(), state_->width, state_->height);
    const auto hit = glint::pick(seen, state_->width / 2.0, state_->height / 2.0);
    camera.set_target(hit ? hit->distance : camera.target_distance());
}

CameraControl Session::camera() const {
    const std::lock_guard lock(state_->mutex);
    return state_->camera;
}

void Session::resize(int width, int height) {
    const std::lock_guard lock(state_->mutex);
    if (width == state_->width && height == state_->height) return;
    state_->width = width;
    state_->height = height;
    state_->renderer.set_camera(state_->camera.camera(), width, height);
}

int Session::width() const {
    const std::lock_guard lock(state_->mutex);
    return state_->width;
}

int Session::height() const {
    const std::lock_guard lock(state_->mutex);
    return state_->height;
}

std::optional<Scene> Session::scene_in_view(ViewSlot slot) const {
    const std::lock_guard lock(state_->mutex);
    const auto& scene = state_->scenes[slot];
    if (!scene) return std::nullopt;
    return with_view(*scene, state_->camera.camera(), state_->width, state_->height);
}

std::optional<Pick> Session::pick(double x, double y) const {
    const std::optional<Scene> seen = scene_in_view();
    return seen ? glint::pick(*seen, x, y) : std::nullopt;
}

std::shared_ptr<const RenderedFrame> Session::frame(ViewSlot slot) const {
    return state_->renderer.latest(slot);
}

void Session::explain(ViewSlot slot, int x, int y) {
    const std::lock_guard lock(state_->mutex);
    state_->explainer.ask({slot, state_->camera.camera(), state_->width, state_->height, x, y});
}

void Session::stop_explaining() { state_->explainer.forget(); }
std::shared_ptr<const PixelAnswer> Session::explained() const { return state_->explainer.latest(); }
bool Session::is_explaining() const { return state_->explainer.is_busy(); }

} // namespace glint::viewer
