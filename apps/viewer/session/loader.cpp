// The loader's thread: reads the last file asked for, looks whether it changes, builds edits.
#include "loader.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <map>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace glint::viewer {
namespace {

/// An error of a file that is not about its content.
std::vector<Diagnostic> problem(const std::string& path, std::string message) {
    return {{Severity::error, {path, 0, 0, {}}, std::move(message), {}, {}}};
}

/// The window reads a file again whenever it changes. Editors that empty a file before they write it have
/// not written it yet.
void require_written_file(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code missing;
    const fs::file_status status = fs::status(path, missing);
    if (missing || fs::is_directory(status)) return; // load_scene() says why that cannot be read
    if (!fs::is_regular_file(status))
        throw Error(ErrorKind::input, "a window shows regular files only", "write it to a file first",
                    {.file = path});
    if (fs::file_size(path, missing) == 0 && !missing)
        throw Error(ErrorKind::input, "the file is empty", "it is read again when it has been written",
                    {.file = path});
}

/// Takes the data of meshes that were not read from the scene, by file name.
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

/// Compares modification time, size and existence of files when asked. File system notifications would not be
/// simpler: editors save in too many ways.
class FileWatch {
  public:
    /// Watches these files too, from their present state; files watched already keep the state last seen.
    void watch(const std::vector<std::string>& files) {
        for (const std::string& file : files) known_.try_emplace(file, stamp_of(file));
        before_ = known_;
    }

    /// Has a file changed since it was last seen, and not since the last call? True once for each change.
    bool has_changed() {
        std::map<std::string, Stamp> now;
        for (const auto& [file, stamp] : known_) now[file] = stamp_of(file);
        // A file that has changed since the last call may be half written.
        const bool is_settled = now == before_;
        before_ = now;
        if (!is_settled || now == known_) return false;
        known_ = std::move(now);
        return true;
    }

  private:
    /// Time and size; none for a file that is not there.
    using Stamp = std::optional<std::pair<std::filesystem::file_time_type, std::uintmax_t>>;
    static Stamp stamp_of(const std::string& file) {
        std::error_code no_time, no_size;
        const auto time = std::filesystem::last_write_time(file, no_time);
        const std::uintmax_t size = std::filesystem::file_size(file, no_size);
        return no_time || no_size ? Stamp() : std::pair(time, size);
    }

    std::map<std::string, Stamp> known_;  ///< as last reported
    std::map<std::string, Stamp> before_; ///< at the last call
};

} // namespace

struct SessionLoader::State {
    explicit State(Options given) : options(std::move(given)) {}

    const Options options;

    /// What the thread is to do next.
    struct Tasks {
        std::optional<std::string> open;
        bool reload = false;
        PerView<std::optional<SceneDescription>> edits;
    };

    mutable std::mutex mutex;
    std::condition_variable wake;
    // Guarded by `mutex`.
    Tasks waiting;
    bool closing = false;
    LoadStatus status;

    // Atomic. Set under `mutex` when the file being read is not wanted any more; cleared by the thread.
    CancelFlag cancel{false};

    // Of the loader's thread alone.
    std::string path;           ///< of the last file asked for
    std::optional<Scene> scene; ///< the last good one, with edits
    std::string scene_path;
    std::uint64_t loads = 0;
    std::vector<std::string> scene_files;
    FileWatch watch;

    std::thread thread; ///< last: uses all of the above

    void post(const std::function<void()>& change) {
        {
            const std::lock_guard lock(mutex);
            change();
        }
        wake.notify_one();
    }
    void run();
    bool wait(Tasks& tasks);
    void set_status(const std::function<void(LoadStatus&)>& change);
    void read(bool is_reload);
    LoadedFile read_file();
    void go_back();
    BuildSceneOptions build_options() const;
    void build_edit(ViewSlot slot, SceneDescription description);
    template <class Work>
    void guarded(const Work& work);
};

/// Waits for tasks, or until it is time to look at the files; false at the end.
bool SessionLoader::State::wait(Tasks& tasks) {
    const auto tick = std::chrono::duration<double>(options.watch_seconds);
    std::unique_lock lock(mutex);
    wake.wait_for(lock, tick, [&] {
        return closing || waiting.open || waiting.reload || waiting.edits[ViewSlot::main] ||
               waiting.edits[ViewSlot::reference];
    });
    if (closing) return false;
    tasks = std::exchange(waiting, {});
    cancel = false;
    return true;
}

void SessionLoader::State::run() {
    for (Tasks tasks; wait(tasks);) {
        if (tasks.open) {
            path = *tasks.open;
            watch = {};
            read(false);
        } else if (!path.empty() && (tasks.reload || (options.watch && watch.has_changed()))) {
            read(scene && scene_path == path);
        }
        for (const ViewSlot slot : view_slots)
            if (tasks.edits[slot] && scene) build_edit(slot, std::move(*tasks.edits[slot]));
    }
}

void SessionLoader::State::set_status(const std::function<void(LoadStatus&)>& change) {
    {
        const std::lock_guard lock(mutex);
        change(status);
    }
    if (options.changed) options.changed();
}

/// Runs work; its errors go to the status.
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
        ++s.changes;
    });
}

void SessionLoader::State::read(bool is_reload) {
    set_status([&](LoadStatus& s) { s = {true, path, {"reading " + path, 0}, {}, s.changes + 1}; });
    guarded([&] {
        // Before reading: a change while the file is read counts too.
        watch.watch({path});
        LoadedFile file = read_file();
        file.is_reload = is_reload;
        file.loads = ++loads;
        scene = file.scene;
        scene_path = path;
        if (options.loaded) options.loaded(std::move(file));
    });
}

/// After cancelling: back to the scene before, whose file is watched again.
void SessionLoader::State::go_back() {
    if (!scene || path == scene_path) return;
    path = scene_path;
    watch = {};
    watch.watch(scene_files);
}

LoadedFile SessionLoader::State::read_file() {
    const auto report = [this](const LoadProgress& progress) {
        set_status([&](LoadStatus& s) { s.progress = progress; });
    };
    LoadOptions load = options.load;
    load.cancel = &cancel;
    load.progress = report;
    require_written_file(path);
    LoadedScene loaded = load_scene(path, load);
    watch.watch(loaded.files);
    BuildSceneOptions build = build_options();
    build.progress = report;
    LoadedFile file{path,
                    build_scene(loaded.description, build),
                    std::move(loaded.warnings),
                    std::move(loaded.notes),
                    false,
                    0};
    scene_files = loaded.files;
    if (cancel) throw Error(ErrorKind::cancelled, "reading was cancelled");
    const std::vector<Diagnostic> scene_warnings = warnings(file.scene);
    file.warnings.insert(file.warnings.end(), scene_warnings.begin(), scene_warnings.end());
    return file;
}

/// Solids are found even while no material is transparent: an edit may make one so.
BuildSceneOptions SessionLoader::State::build_options() const {
    BuildSceneOptions build;
    build.threads = options.threads;
    build.find_solids = true;
    build.cancel = &cancel;
    return build;
}

void SessionLoader::State::build_edit(ViewSlot slot, SceneDescription description) {
    guarded([&] {
        fill_in_meshes(description, scene->description());
        Scene edited = update_scene(*scene, description, build_options());
        // Later edits share the trees that were just built.
        if (slot == ViewSlot::main) scene = edited;
        if (options.edited) options.edited(slot, std::move(edited));
    });
}

SessionLoader::SessionLoader(Options options) : state_(std::make_unique<State>(std::move(options))) {
    state_->thread = std::thread([state = state_.get()] { state->run(); });
}

SessionLoader::~SessionLoader() {
    state_->post([this] {
        state_->closing = true;
        state_->cancel = true;
    });
    state_->thread.join();
}

void SessionLoader::open(const std::string& path) {
    state_->post([&] {
        state_->waiting = {};
        state_->waiting.open = path;
        state_->cancel = true;
        state_->status = {true, path, {"reading " + path, 0}, {}};
    });
}

void SessionLoader::reload() {
    state_->post([this] { state_->waiting.reload = true; });
}

void SessionLoader::cancel() {
    state_->post([this] {
        if (state_->waiting.open) state_->status.busy = false;
        state_->waiting.open.reset();
        state_->waiting.reload = false;
        state_->cancel = true;
    });
}

void SessionLoader::edit(ViewSlot slot, SceneDescription description) {
    state_->post([&] { state_->waiting.edits[slot] = std::move(description); });
}

LoadStatus SessionLoader::status() const {
    const std::lock_guard lock(state_->mutex);
    return state_->status;
}

} // namespace glint::viewer
