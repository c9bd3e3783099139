#pragma once
// Scene files on a thread of their own: read, frozen, watched, and frozen anew with other values.

#include "glint/formats.h"
#include "glint/scene.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// A scene file that was read and frozen.
struct LoadedFile {
    std::string path;
    Scene scene;
    std::vector<Diagnostic> warnings; ///< of the files and of the scene
    std::vector<std::string> notes;
    bool is_reload = false; ///< the same file again
};

/// What the loader is about, and what became of the last file.
struct LoadStatus {
    bool busy = false;
    std::string path; ///< of the file that is read or was read last
    LoadProgress progress;
    std::vector<Diagnostic> problems; ///< why it could not be shown; empty where it is shown
};

/// All functions may be called by any thread, and none waits for reading or freezing.
class SessionLoader {
  public:
    struct Options {
        LoadOptions load;  ///< cancel and progress are the loader's own
        int threads = 0;   ///< 0: one for each core
        bool watch = true; ///< read files again when they or their meshes change
        double watch_seconds = 0.15;
        std::function<void(LoadedFile)> loaded;
        /// An edit has become a scene.
        std::function<void(int place, Scene)> edited;
        std::function<void()> changed; ///< the status is another
    };

    /// All calls back are made by the loader's thread.
    explicit SessionLoader(Options options);
    /// Ends within a fraction of a second, whatever is under way.
    ~SessionLoader();
    SessionLoader(const SessionLoader&) = delete;
    SessionLoader& operator=(const SessionLoader&) = delete;

    /// Reads a file; what was being read is given up.
    void open(const std::string& path);
    /// Reads the last file again.
    void reload();
    /// Gives up what is being read. The file is watched all the same.
    void cancel();
    /// Freezes other values of the last good scene for a place; of several waiting for one the last counts.
    /// Meshes without data get those that the scene has under the same name of file.
    void edit(int place, SceneDescription description);

    LoadStatus status() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
