#pragma once
// The scene file being edited: its document with unsaved changes, undo and redo, and the session that shows
// it.

#include "arguments.h"
#include "file_keys.h"
#include "session/clock.h"
#include "session/explain_command.h"
#include "session/session.h"
#include "widgets.h"

#include "glint/document.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

/// For the window's thread. No call waits for reading, building or rendering.
class SceneEditor {
  public:
    /// `wake` is called on other threads when there is something new.
    SceneEditor(const Arguments& arguments, std::function<void()> wake);

    void open(const std::string& file) { session_->open(file); }
    /// What is new since the last update(): nothing, a picture, or something about the file.
    enum class News { none, picture, file };
    /// Takes over the session's news.
    News update();

    Session& session() { return *session_; }
    const Session& session() const { return *session_; }
    /// The scene shown, with unsaved changes; null before the first one.
    const SceneDescription* description() const { return loaded_ ? &shown_.description : nullptr; }
    /// The same as the session has it. Requires description().
    const LoadedFile& loaded() const { return *loaded_; }
    const LoadStatus& status() const { return status_; }
    /// Errors of the file, or of a refused change; empty if there are none.
    const std::vector<Diagnostic>& problems() const;
    /// The latest picture of a view, as of update(); null before there is any.
    std::shared_ptr<const RenderedFrame> frame(ViewSlot slot = ViewSlot::main) const { return frames_[slot]; }
    /// The explanation of a pixel, as of update(), and whether a new one is under way.
    std::shared_ptr<const PixelAnswer> explained() const { return explained_; }
    bool is_explaining() const { return explaining_; }
    /// The keys of the document.
    const FileKeys& keys() const { return keys_; }
    /// Diagonal of the bounding box, or 10 without one.
    double extent() const { return extent_; }
    /// The file shown, scene or mesh; before the first one, the one being read. A mesh saved as a scene is
    /// that scene.
    const std::string& file() const { return loaded_ ? shown_.file : status_.path; }

    /// Changes the camera, as Session::move() and Session::orbit().
    void move(const std::function<void(CameraControl&)>& change);
    void orbit(double right, double up);
    /// Call when something has changed that the pictures show, or how they are rendered; done by itself after
    /// edits and movements.
    void note_change() { last_change_ = now(); }
    /// Times of now() at the last change and at the last movement of the camera; 0: never.
    double last_change() const { return last_change_; }
    double last_move() const { return last_move_; }
    /// Has what changed before `time`, and before the last change, reached the pictures?
    bool is_settled(double time = 0) const;

    /// Null if nothing is animated.
    const Animation* animation() const;
    /// Shows a frame of the animation, also fractional ones.
    void show_at(double frame);
    /// The key paths that the frame shown sets, with the names of objects; empty before show_at().
    std::vector<std::string> animated() const;
    /// The frame shown, the first one before show_at(). Requires animation().
    double frame_shown() const { return shown_.frame.value_or(animation()->first); }

    /// Sets values. A new step of undo() unless `same_gesture`.
    void edit(const std::vector<Edit>& edits, bool same_gesture);
    void undo();
    void redo();
    bool is_changed() const { return shown_.document && shown_.document->changed(); }
    /// Writes the scene and returns the file's name; for a mesh, a new scene file beside it. Throws Error.
    std::string save();

    /// Keeps the scene as it is now for the reference view.
    void keep();
    bool has_kept() const { return kept_.has_value(); }
    /// What a view shows: the file with unsaved changes, or what was kept.
    const ShownFile& shown_file(ViewSlot slot) const {
        return slot == ViewSlot::reference && kept_ ? *kept_ : shown_;
    }
    /// Renders the reference view, if anything was kept.
    void compare(bool on);

  private:
    void take_scene(const LoadedFile& scene);
    void take_document(const LoadedFile& scene);
    /// Shows the document as it is now.
    void show_document();
    void read_document();
    void step(std::vector<SceneDocument>& from, std::vector<SceneDocument>& to);

    std::atomic<bool> has_news_{false}; ///< of the session, since update()
    std::optional<LoadedFile> loaded_;
    ShownFile shown_;
    std::optional<LoadedScene> parsed_; ///< its document without its meshes
    FileKeys keys_;                     ///< of its document
    std::vector<SceneDocument> undo_;
    std::vector<SceneDocument> redo_;
    std::optional<ShownFile> kept_;
    std::vector<Diagnostic> refused_; ///< errors of the last change, if it was refused
    LoadStatus status_;
    PerView<std::shared_ptr<const RenderedFrame>> frames_;
    std::shared_ptr<const PixelAnswer> explained_;
    bool explaining_ = false;
    double extent_ = 1;
    double last_change_ = 0;
    double last_move_ = 0;
    std::unique_ptr<Session> session_; ///< last: its threads end first
};

} // namespace glint::viewer
