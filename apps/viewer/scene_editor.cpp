// Edits of the document, undo, and what the session reports.
#include "scene_editor.h"

#include "glint/explain.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <filesystem>
#include <future>
#include <sys/resource.h>

namespace glint::viewer {
namespace {

constexpr std::size_t max_undo = 200;

/// Time that a change takes to reach the pictures, at most.
constexpr double settle_seconds = 0.25;

/// The session's threads inherit a lower priority from the one that creates them, so that the window stays
/// responsive on machines with few cores.
std::unique_ptr<Session> begin_session(const Arguments& arguments, std::function<void()> changed) {
    constexpr int nice_level = 5;
    SessionOptions options;
    options.load = arguments.load;
    options.threads = arguments.threads;
    options.changed = std::move(changed);
    return std::async(std::launch::async,
                      [&options] {
                          setpriority(PRIO_PROCESS, 0, nice_level);
                          return std::make_unique<Session>(std::move(options));
                      })
        .get();
}

double extent_of(const Scene& scene) {
    const SceneStats stats = scene.stats();
    const double diagonal = glm::length(stats.bounds_max - stats.bounds_min);
    return stats.bounds_min.x <= stats.bounds_max.x && diagonal > 0 ? diagonal : 10;
}

} // namespace

SceneEditor::SceneEditor(const Arguments& arguments, std::function<void()> wake)
    : session_(begin_session(arguments, [this, wake = std::move(wake)] {
          has_news_ = true;
          wake();
      })) {
    shown_.load = arguments.load;
}

SceneEditor::News SceneEditor::update() {
    const bool has_news = has_news_.exchange(false);
    bool is_about_file = false;
    if (const auto scene = session_->scene(); scene && (!loaded_ || scene->loads != loaded_->loads)) {
        take_scene(*scene);
        is_about_file = true;
    }
    LoadStatus status = session_->load_status();
    is_about_file = is_about_file || status.changes != status_.changes;
    status_ = std::move(status);
    for (const ViewSlot slot : view_slots) frames_[slot] = session_->frame(slot);
    // In this order: an answer that arrives in between is taken the next time.
    explaining_ = session_->is_explaining();
    explained_ = session_->explained();
    return is_about_file ? News::file : has_news ? News::picture : News::none;
}

void SceneEditor::orbit(double right, double up) {
    session_->orbit(right, up);
    last_change_ = last_move_ = now();
}

void SceneEditor::move(const std::function<void(CameraControl&)>& change) {
    session_->move(change);
    last_change_ = last_move_ = now();
}

bool SceneEditor::is_settled(double time) const {
    return !status_.busy && now() - std::max(time, last_change_) > settle_seconds;
}

void SceneEditor::take_scene(const LoadedFile& scene) {
    const bool is_another_file = !loaded_ || loaded_->path != scene.path;
    if (is_another_file) {
        kept_.reset();
        session_->compare({});
        keys_ = {};
        parsed_.reset();
        shown_ = {scene.path, std::move(shown_.load), {}, {}, {}, {}};
    }
    loaded_ = scene;
    shown_.description = scene.scene.description();
    extent_ = extent_of(scene.scene);
    refused_.clear();
    take_document(scene);
}

/// Reads the file as a document and applies the unsaved changes to it again.
void SceneEditor::take_document(const LoadedFile& scene) {
    try {
        if (!is_scene_file(scene.path)) {
            if (shown_.document) return;
            shown_.document = preview_document(shown_.description, scene.path);
            read_document();
            return;
        }
        SceneDocument fresh = SceneDocument::open(scene.path);
        if (!shown_.load.overrides.empty()) fresh.set_all(shown_.load.overrides);
        if (shown_.document && shown_.document->text() == fresh.text()) return;
        const bool edited = shown_.document && shown_.document->changed();
        const std::string text = SceneDocument::open(scene.path).text();
        // The file has not changed: unsaved changes are kept, with their undo steps.
        if (edited && shown_.document->is_saved_as(text)) return show_document();
        if (edited) {
            shown_.document->rebase(text);
        } else {
            shown_.document = std::move(fresh);
        }
        undo_.clear();
        redo_.clear();
        if (edited) {
            show_document();
        } else {
            read_document();
        }
    } catch (const Error& error) {
        refused_ = error.diagnostics();
    }
}

void SceneEditor::read_document() {
    LoadOptions options = shown_.load;
    options.load_meshes = false;
    // The document contains them.
    options.overrides.clear();
    parsed_ = parse_scene(shown_.document->text(), shown_.document->name(), options);
    keys_ = FileKeys(*shown_.document);
    shown_.animated = animation() != nullptr ? animation()->keys : std::vector<std::string>();
}

void SceneEditor::show_document() {
    read_document();
    shown_.description =
        animation() != nullptr && shown_.frame ? scene_at(*parsed_, *shown_.frame) : parsed_->description;
    session_->edit(shown_.description);
    note_change();
}

const Animation* SceneEditor::animation() const {
    return parsed_ && parsed_->animation.scene ? &parsed_->animation : nullptr;
}

void SceneEditor::show_at(double frame) {
    shown_.frame = frame;
    shown_.description = scene_at(*parsed_, frame);
    session_->edit(shown_.description);
    const auto moves_camera = [](const std::string& key) { return key.rfind("camera.", 0) == 0; };
    const std::vector<std::string>& keys = animation()->keys;
    if (shown_.description.camera && std::any_of(keys.begin(), keys.end(), moves_camera))
        session_->move(
            [&](CameraControl& c) { c.set_camera(*shown_.description.camera, c.target_distance()); });
    note_change();
}

std::vector<std::string> SceneEditor::animated() const {
    if (animation() == nullptr || !shown_.frame) return {};
    std::vector<std::string> keys = animation()->keys;
    for (std::string& key : keys) key = named_key(shown_.description, key);
    return keys;
}

const std::vector<Diagnostic>& SceneEditor::problems() const {
    return refused_.empty() ? status_.problems : refused_;
}

void SceneEditor::edit(const std::vector<Edit>& edits, bool same_gesture) {
    if (edits.empty() || !shown_.document) return;
    std::vector<Override> values;
    for (const Edit& edit : edits) values.push_back(edit.path + "=" + edit.value);
    const SceneDocument before = *shown_.document;
    try {
        shown_.document->set_all(values);
        show_document();
        refused_.clear();
    } catch (const Error& error) {
        shown_.document = before;
        keys_ = FileKeys(*shown_.document);
        refused_ = error.diagnostics();
        return;
    }
    if (!same_gesture || undo_.empty()) undo_.push_back(before);
    if (undo_.size() > max_undo) undo_.erase(undo_.begin());
    redo_.clear();
}

void SceneEditor::step(std::vector<SceneDocument>& from, std::vector<SceneDocument>& to) {
    if (from.empty()) return;
    to.push_back(*shown_.document);
    // The file may have been saved since that step.
    from.back().take_saved(*shown_.document);
    shown_.document = std::move(from.back());
    from.pop_back();
    show_document();
}

void SceneEditor::undo() { step(undo_, redo_); }

void SceneEditor::redo() { step(redo_, undo_); }

std::string SceneEditor::save() {
    const std::string name = shown_.document->name();
    if (is_scene_file(shown_.file)) {
        shown_.document->save();
    } else {
        std::error_code none;
        if (std::filesystem::exists(name, none))
            throw Error(ErrorKind::output,
                        name + " exists already: move it away, or open it instead of the mesh");
        shown_.document->save_as(name);
        shown_.file = name;
    }
    note_change();
    return name;
}

void SceneEditor::keep() {
    kept_ = shown_;
    if (session_->is_comparing()) session_->compare(kept_->description);
}

void SceneEditor::compare(bool on) {
    on = on && kept_.has_value();
    if (on != session_->is_comparing())
        session_->compare(on ? std::optional(kept_->description) : std::nullopt);
}

} // namespace glint::viewer
