#include "session.h"

#include <array>
#include <mutex>
#include <utility>

namespace glint::viewer {

struct Session::State {
    explicit State(SessionOptions given)
        : options(std::move(given)), width(options.width), height(options.height),
          renderer({options.threads, options.first_picture_seconds, options.changed}),
          explainer(options.changed), loader(loader_options()) {}

    SessionLoader::Options loader_options() {
        SessionLoader::Options how;
        how.load = options.load;
        how.threads = options.threads;
        how.watch = options.watch;
        how.loaded = [this](LoadedFile file) { show(std::move(file)); };
        how.edited = [this](int place, Scene edited) { show(place, std::move(edited)); };
        how.changed = options.changed;
        return how;
    }

    const SessionOptions options;

    mutable std::mutex mutex; ///< guards the following
    std::optional<SessionScene> scene;
    std::array<std::optional<Scene>, picture_places> scenes;
    std::array<Aspect, picture_places> show_of{};
    Kernel kernel = Kernel::automatic;
    bool comparing = false;
    CameraControl camera;
    int width;
    int height;

    // Last, so that they end first: their threads call back.
    SessionRenderer renderer;
    SessionExplainer explainer;
    SessionLoader loader;

    /// A file was read.
    void show(LoadedFile file) {
        const std::lock_guard lock(mutex);
        const bool keeps_camera = file.is_reload && scene;
        const double distance = target_distance(file.scene);
        CameraControl fresh(file.scene.camera(), distance);
        if (keeps_camera) fresh.set_camera(camera.camera(), camera.target_distance());
        camera = fresh;
        const std::uint64_t loads = scene ? scene->loads + 1 : 1;
        scene = SessionScene{std::move(file.path), file.scene, std::move(file.warnings),
                             std::move(file.notes), loads};
        comparing = comparing && keeps_camera;
        if (!keeps_camera) explainer.forget();
        set_scene(0, file.scene);
        if (!comparing) set_scene(1, std::nullopt);
        renderer.set_view(camera.camera(), width, height);
        if (options.changed) options.changed();
    }

    /// Values were edited.
    void show(int place, Scene edited) {
        const std::lock_guard lock(mutex);
        if (place == 1 && !comparing) return;
        if (place == 0 && scene) scene->scene = edited;
        set_scene(place, std::move(edited));
    }

    void set_scene(int place, std::optional<Scene> wanted) {
        scenes[static_cast<std::size_t>(place)] = wanted;
        explainer.set_scene(place, wanted);
        renderer.set_scene(place, std::move(wanted));
    }
};

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

void Session::edit(SceneDescription description) { state_->loader.edit(0, std::move(description)); }

void Session::compare(std::optional<SceneDescription> description) {
    {
        const std::lock_guard lock(state_->mutex);
        state_->comparing = description.has_value();
        if (!description) state_->set_scene(1, std::nullopt);
    }
    if (description) state_->loader.edit(1, std::move(*description));
}

bool Session::is_comparing() const {
    const std::lock_guard lock(state_->mutex);
    return state_->comparing;
}

void Session::set_show(Aspect show, int place) {
    const std::lock_guard lock(state_->mutex);
    Aspect& now = state_->show_of[static_cast<std::size_t>(place)];
    if (now == show) return;
    now = show;
    state_->renderer.set_show(place, show);
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

Aspect Session::show(int place) const {
    const std::lock_guard lock(state_->mutex);
    return state_->show_of[static_cast<std::size_t>(place)];
}

void Session::set_backend(PainterMaker gpu) { state_->renderer.set_backend(std::move(gpu)); }

void Session::move(const std::function<void(CameraControl&)>& change) {
    const std::lock_guard lock(state_->mutex);
    change(state_->camera);
    state_->renderer.set_view(state_->camera.camera(), state_->width, state_->height);
}

void Session::aim() {
    const std::lock_guard lock(state_->mutex);
    CameraControl& camera = state_->camera;
    const auto& scene = state_->scenes[0];
    if (camera.is_aimed() || !scene) return;
    const Scene seen = with_view(*scene, camera.camera(), state_->width, state_->height);
    const auto middle = glint::pick(seen, state_->width / 2.0, state_->height / 2.0);
    camera.aim(middle ? middle->distance : camera.target_distance());
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
    state_->renderer.set_view(state_->camera.camera(), width, height);
}

int Session::width() const {
    const std::lock_guard lock(state_->mutex);
    return state_->width;
}

int Session::height() const {
    const std::lock_guard lock(state_->mutex);
    return state_->height;
}

std::optional<Scene> Session::view(int place) const {
    const std::lock_guard lock(state_->mutex);
    const auto& scene = state_->scenes[static_cast<std::size_t>(place)];
    if (!scene) return std::nullopt;
    return with_view(*scene, state_->camera.camera(), state_->width, state_->height);
}

std::optional<Pick> Session::pick(double x, double y) const {
    const std::optional<Scene> seen = view();
    return seen ? glint::pick(*seen, x, y) : std::nullopt;
}

std::shared_ptr<const Frame> Session::frame(int place) const { return state_->renderer.latest(place); }

void Session::explain(int place, int x, int y) {
    const std::lock_guard lock(state_->mutex);
    state_->explainer.ask({place, state_->camera.camera(), state_->width, state_->height, x, y});
}

void Session::stop_explaining() { state_->explainer.forget(); }
std::shared_ptr<const PixelAnswer> Session::explained() const { return state_->explainer.latest(); }
bool Session::is_explaining() const { return state_->explainer.is_busy(); }

} // namespace glint::viewer
