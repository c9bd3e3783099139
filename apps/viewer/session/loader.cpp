#include "loader.h"

#include "watch.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

namespace glint::viewer {
namespace {

constexpr std::size_t places = 2;

/// What is wrong with a file that something else than its content went wrong with.
std::vector<Diagnostic> problem(const std::string& path, std::string message) {
    return {{Severity::error, {path, 0, 0, {}}, std::move(message), {}, {}}};
}

/// Meshes that were not read are those of the scene, by the name of their file.
void fill_in_meshes(SceneDescription& description, const SceneDescription& known) {
    for (Object& object : description.objects) {
        auto* mesh = std::get_if<MeshShape>(&object.shape);
        if (mesh == nullptr || mesh->data != nullptr) continue;
        for (const Object& other : known.objects) {
            const auto* source = std::get_if<MeshShape>(&other.shape);
            if (source != nullptr && source->file == mesh->file) mesh->data = source->data;
        }
    }
}

} // namespace

struct SessionLoader::State {
    explicit State(Options given) : options(std::move(given)) {}

    const Options options;

    mutable std::mutex mutex; ///< guards the following
    std::condition_variable wished;
    std::optional<std::string> to_open;
    bool to_reload = false;
    std::array<std::optional<SceneDescription>, places> edits;
    bool closing = false;
    LoadStatus status;

    CancelFlag cancel{false};
    std::thread thread;

    // Of the loader's thread alone.
    std::string path;           ///< of the file that was asked for last
    std::optional<Scene> scene; ///< the last good one, with what was edited
    std::string scene_path;
    std::vector<std::string> scene_files;
    FileWatch watch;

    /// One thing to do.
    struct Task {
        std::optional<std::string> open;
        bool reload = false;
        std::array<std::optional<SceneDescription>, places> edits;
    };

    void wake(const std::function<void()>& change) {
        {
            const std::lock_guard lock(mutex);
            change();
        }
        wished.notify_one();
    }
    void run();
    bool wait(Task& task);
    void set_status(const std::function<void(LoadStatus&)>& change);
    void read(bool is_reload);
    LoadedFile read_file();
    void go_back();
    void freeze_edit(std::size_t place, SceneDescription description);
    template <class Work>
    void guarded(const Work& work);
};

/// The next thing to do; false at the end.
bool SessionLoader::State::wait(Task& task) {
    const auto tick = std::chrono::duration<double>(options.watch_seconds);
    std::unique_lock lock(mutex);
    wished.wait_for(lock, tick, [&] {
        return closing || to_open || to_reload || edits[0].has_value() || edits[1].has_value();
    });
    if (closing) return false;
    task.open = std::exchange(to_open, std::nullopt);
    task.reload = std::exchange(to_reload, false);
    for (std::size_t i = 0; i < places; ++i) task.edits[i] = std::exchange(edits[i], std::nullopt);
    cancel = false;
    return true;
}

void SessionLoader::State::run() {
    for (Task task; wait(task); task = {}) {
        if (task.open) {
            path = *task.open;
            watch = {};
            read(false);
        } else if (!path.empty() && (task.reload || (options.watch && watch.has_changed()))) {
            read(scene && scene_path == path);
        }
        for (std::size_t place = 0; place < places; ++place)
            if (task.edits[place] && scene) freeze_edit(place, std::move(*task.edits[place]));
    }
}

void SessionLoader::State::set_status(const std::function<void(LoadStatus&)>& change) {
    {
        const std::lock_guard lock(mutex);
        change(status);
    }
    if (options.changed) options.changed();
}

/// Does the work; what goes wrong becomes the status.
template <class Work>
void SessionLoader::State::guarded(const Work& work) {
    std::vector<Diagnostic> problems;
    try {
        work();
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled)
            go_back();
        else
            problems = error.diagnostics();
    } catch (const std::bad_alloc&) {
        problems = problem(path, "out of memory");
    } catch (const std::exception& other) {
        problems = problem(path, other.what());
    }
    set_status([&](LoadStatus& s) {
        s.busy = false;
        s.problems = std::move(problems);
    });
}

void SessionLoader::State::read(bool is_reload) {
    set_status([&](LoadStatus& s) { s = {true, path, {"reading " + path, 0}, {}}; });
    guarded([&] {
        // What changes from now on is seen, even while it is read.
        watch.look_at({path});
        LoadedFile file = read_file();
        file.is_reload = is_reload;
        scene = file.scene;
        scene_path = path;
        if (options.loaded) options.loaded(std::move(file));
    });
}

/// To the scene before, whose file is watched again.
void SessionLoader::State::go_back() {
    if (!scene || path == scene_path) return;
    path = scene_path;
    watch = {};
    watch.look_at(scene_files);
}

LoadedFile SessionLoader::State::read_file() {
    const auto tell = [this](const LoadProgress& progress) {
        set_status([&](LoadStatus& s) { s.progress = progress; });
    };
    LoadOptions load = options.load;
    load.cancel = &cancel;
    load.progress = tell;
    LoadedScene loaded = load_scene(path, load);
    watch.look_at(loaded.files);
    FreezeOptions how;
    how.threads = options.threads;
    how.find_solids = true;
    how.cancel = &cancel;
    how.progress = tell;
    LoadedFile file{path, freeze(loaded.description, how), std::move(loaded.warnings),
                    std::move(loaded.notes), false};
    scene_files = loaded.files;
    if (cancel) throw Error(ErrorKind::cancelled, "reading was cancelled");
    const std::vector<Diagnostic> of_scene = warnings(file.scene);
    file.warnings.insert(file.warnings.end(), of_scene.begin(), of_scene.end());
    return file;
}

void SessionLoader::State::freeze_edit(std::size_t place, SceneDescription description) {
    guarded([&] {
        fill_in_meshes(description, scene->description());
        FreezeOptions how;
        how.threads = options.threads;
        how.find_solids = true;
        how.cancel = &cancel;
        Scene edited = refreeze(*scene, description, how);
        // Further edits of objects that moved share what was just built.
        if (place == 0) scene = edited;
        if (options.edited) options.edited(static_cast<int>(place), std::move(edited));
    });
}

SessionLoader::SessionLoader(Options options) : state_(std::make_unique<State>(std::move(options))) {
    state_->thread = std::thread([state = state_.get()] { state->run(); });
}

SessionLoader::~SessionLoader() {
    state_->wake([this] {
        state_->closing = true;
        state_->cancel = true;
    });
    state_->thread.join();
}

void SessionLoader::open(const std::string& path) {
    state_->wake([&] {
        state_->to_open = path;
        state_->to_reload = false;
        state_->edits = {};
        state_->cancel = true;
        state_->status = {true, path, {"reading " + path, 0}, {}};
    });
}

void SessionLoader::reload() {
    state_->wake([this] { state_->to_reload = true; });
}

void SessionLoader::cancel() {
    state_->wake([this] {
        if (state_->to_open) state_->status.busy = false;
        state_->to_open.reset();
        state_->to_reload = false;
        state_->cancel = true;
    });
}

void SessionLoader::edit(int place, SceneDescription description) {
    state_->wake([&] { state_->edits[static_cast<std::size_t>(place)] = std::move(description); });
}

LoadStatus SessionLoader::status() const {
    const std::lock_guard lock(state_->mutex);
    return state_->status;
}

} // namespace glint::viewer
