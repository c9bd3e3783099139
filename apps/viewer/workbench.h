#pragma once
// The scene file under work: its document with the changes made to it, over the session that shows it.

#include "arguments.h"
#include "file_keys.h"
#include "session/explain_command.h"
#include "session/session.h"
#include "widgets.h"

#include "glint/document.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// For the thread of the window. No call waits for reading, freezing or rendering.
class Workbench {
  public:
    /// `wake` is called by other threads when there is something new.
    Workbench(const Arguments& arguments, std::function<void()> wake);

    void open(const std::string& file);
    /// Takes what the session has got since the last call; true if there is anything new to be seen.
    bool update();

    Session& session() { return *session_; }
    const Session& session() const { return *session_; }
    /// What is shown, with the changes made here; none before the first scene.
    const SceneDescription* description() const { return shown_ ? &description_ : nullptr; }
    /// As the session has it. Only where there is a description.
    const SessionScene& shown() const { return *shown_; }
    const LoadStatus& status() const { return status_; }
    /// What is wrong with the file, or with a change that was not taken; empty where all is well.
    const std::vector<Diagnostic>& problems() const;
    std::shared_ptr<const Frame> frame(int place) const { return frames_[static_cast<std::size_t>(place)]; }
    /// What the session has explained, and whether it still does.
    std::shared_ptr<const PixelAnswer> explained() const { return explained_; }
    bool is_explaining() const { return explaining_; }
    /// What the file says, with the changes made here.
    const FileKeys& keys() const { return keys_; }
    /// About how large the scene is.
    double extent() const { return extent_; }
    /// The file that was opened, scene or mesh.
    const std::string& file() const { return file_; }

    /// How the scene moves; null where it does not.
    const Animation* animation() const;
    /// Shows a frame of the animation; those between whole ones too.
    void show_at(double frame);
    /// The key paths whose values come from the frame that is shown, objects by their names; none until one
    /// is.
    std::vector<std::string> animated() const;
    /// The frame shown; the first until another was asked for. Only where there is an animation.
    double frame_shown() const { return at_.value_or(animation()->first); }

    /// Sets values; one step of undo() where `same_gesture` is false.
    void edit(const std::vector<Edit>& edits, bool same_gesture);
    void undo();
    void redo();
    bool is_changed() const { return document_ && document_->changed(); }
    /// Writes the scene and returns the file's name. A mesh gets a new scene beside it. Throws Error.
    std::string save();

    /// What is shown becomes A, which later changes are compared with.
    void keep();
    bool has_kept() const { return kept_.has_value(); }
    /// What a picture shows: the changed file, or A.
    ShownFile shown_file(int place) const;
    /// Is A rendered too?
    void compare(bool on);

  private:
    void take_scene(const SessionScene& scene);
    void take_document(const SessionScene& scene);
    /// Shows what the document says now.
    void show_document();
    void read_document();
    void step(std::vector<SceneDocument>& from, std::vector<SceneDocument>& to);

    LoadOptions load_;
    std::string file_;
    std::optional<SessionScene> shown_;
    SceneDescription description_;
    std::optional<LoadedScene> written_; ///< what the document says, without meshes
    std::optional<double> at_;           ///< the frame of the animation; none: the scene as its tables say
    std::optional<SceneDocument> document_;
    FileKeys keys_; ///< of that document
    std::vector<SceneDocument> undo_;
    std::vector<SceneDocument> redo_;
    bool staged_saved_ = false; ///< the mesh has become a scene file
    std::optional<ShownFile> kept_;
    std::vector<Diagnostic> refused_; ///< why the last change was not taken
    LoadStatus status_;
    std::array<std::shared_ptr<const Frame>, picture_places> frames_;
    std::shared_ptr<const PixelAnswer> explained_;
    bool explaining_ = false;
    double extent_ = 1;
    std::unique_ptr<Session> session_; ///< last: its threads end first
};

} // namespace glint::viewer
