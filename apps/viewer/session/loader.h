#pragma once
// Loads scene files on a thread of its own, watches them, and rebuilds scenes with edited values.

#include "view_slot.h"

#include "glint/scene.h"
#include "glint/scene_files.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// A scene file that was read and built.
struct LoadedFile {
    std::string path;
    Scene scene;                      ///< with the camera and size of the file
    std::vector<Diagnostic> warnings; ///< of the files and of the scene
    std::vector<std::string> notes;
    bool is_reload = false;  ///< of the file that was shown before
    std::uint64_t loads = 0; ///< number of files loaded so far; edits do not count
};

/// What the loader is doing, and whether the last file could be shown.
struct LoadStatus {
    bool busy = false;
    std::string path; ///< of the file being read, or the last one read
    LoadProgress progress;
    std::vector<Diagnostic> problems; ///< why it could not be shown; empty if it is shown
    std::uint64_t changes = 0;        ///< how often any of these has changed, other than the progress
};

/// Thread-safe. No call waits for reading or building.
class SessionLoader {
  public:
    struct Options {
        LoadOptions load;            ///< its cancel and progress are replaced by the loader's
        int threads = 0;             ///< 0: one for each processor
        bool watch = true;           ///< reload files when they or their meshes change
        double watch_seconds = 0.15; ///< time between two looks at the files
        std::function<void(LoadedFile)> loaded;
        std::function<void(ViewSlot, Scene)> edited; ///< a scene was built from an edit
        std::function<void()> changed;               ///< the status has changed
    };

    /// All callbacks are called on the loader's thread.
    explicit SessionLoader(Options options);
    /// Cancels what is under way; ends within a fraction of a second.
    ~SessionLoader();
    SessionLoader(const SessionLoader&) = delete;
    SessionLoader& operator=(const SessionLoader&) = delete;

    /// Reads a file instead of the one being read.
    void open(const std::string& path);
    /// Reads the last file again.
    void reload();
    /// Stops reading. The file is still watched.
    void cancel();
    /// Builds the last good scene with other values, for one view; only the last of several waiting edits is
    /// built. Meshes without data take that of the scene's mesh with the same file name.
    void edit(ViewSlot slot, SceneDescription description);

    LoadStatus status() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace glint::viewer
