// Edits of the document, undo, and what the session reports.
#include "workbench.h"

#include "object_names.h"

#include "glint/explain.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <filesystem>
#include <future>
#include <sys/resource.h>

namespace glint::viewer {
namespace {

constexpr std::size_t max_undo = 200;

SessionOptions session_options(const Arguments& arguments, std::function<void()> wake) {
    SessionOptions options;
    options.load = arguments.load;
    options.threads = arguments.threads;
    options.changed = std::move(wake);
    return options;
}

/// The session's threads inherit a lower priority from the one that creates them, so that the window stays
/// responsive on machines with few cores.
std::unique_ptr<Session> begin_session(SessionOptions options) {
    constexpr int nice_level = 5;
    return std::async(std::launch::async,
                      [&options] {
                          setpriority(PRIO_PROCESS, 0, nice_level);
                          return std::make_unique<Session>(std::move(options));
                      })
        .get();
}

bool is_scene_file(const std::string& file) { return std::filesystem::path(file).extension() == ".toml"; }

double extent_of(const Scene& scene) {
    const SceneStats stats = scene.stats();
    const double diagonal = glm::length(stats.bounds_max - stats.bounds_min);
    return stats.bounds_min.x <= stats.bounds_max.x && diagonal > 0 ? diagonal : 10;
}

} // namespace

Workbench::Workbench(const Arguments& arguments, std::function<void()> wake)
    : load_(arguments.load), session_(begin_session(session_options(arguments, std::move(wake)))) {}

void Workbench::open(const std::string& file) {
    file_ = file;
    session_->open(file);
}

bool Workbench::update() {
    bool news = false;
    if (const auto scene = session_->scene(); scene && (!shown_ || scene->loads != shown_->loads)) {
        take_scene(*scene);
        news = true;
    }
    const LoadStatus status = session_->load_status();
    news |= status.busy != status_.busy || status.progress.activity != status_.progress.activity ||
            status.progress.fraction != status_.progress.fraction ||
            status.problems.size() != status_.problems.size() ||
            (!status.problems.empty() && status.problems.front().message != status_.problems.front().message);
    status_ = status;
    for (const ViewSlot slot : view_slots) {
        const auto latest = session_->frame(slot);
        news |= latest != frames_[slot];
        frames_[slot] = latest;
    }
    // In this order: an answer that arrives in between is taken the next time.
    const bool explaining = session_->is_explaining();
    const auto explained = session_->explained();
    news |= explaining != explaining_ || explained != explained_;
    explaining_ = explaining;
    explained_ = explained;
    return news;
}

void Workbench::take_scene(const SessionScene& scene) {
    const bool is_another_file = !shown_ || shown_->path != scene.path;
    if (is_another_file) {
        kept_.reset();
        session_->compare({});
        document_.reset();
        keys_ = {};
        parsed_.reset();
        frame_.reset();
        is_mesh_saved_ = false;
    }
    shown_ = scene;
    description_ = scene.scene.description();
    extent_ = extent_of(scene.scene);
    refused_.clear();
    take_document(scene);
}

/// Reads the file as a document and applies the unsaved changes to it again.
void Workbench::take_document(const SessionScene& scene) {
    try {
        if (!is_scene_file(scene.path)) {
            if (document_) return;
            document_ = preview_document(description_, scene.path);
            read_document();
            return;
        }
        SceneDocument fresh = SceneDocument::open(scene.path);
        if (!load_.overrides.empty()) fresh.set_all(load_.overrides);
        if (document_ && document_->text() == fresh.text()) return;
        const bool edited = document_ && document_->changed();
        const std::string text = SceneDocument::open(scene.path).text();
        // The file has not changed: unsaved changes are kept, with their undo steps.
        if (edited && document_->is_saved_as(text)) return show_document();
        if (edited) {
            document_->rebase(text);
        } else {
            document_ = std::move(fresh);
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

void Workbench::read_document() {
    LoadOptions options = load_;
    options.load_meshes = false;
    // The document contains them.
    options.overrides.clear();
    parsed_ = parse_scene(document_->text(), document_->name(), options);
    keys_ = FileKeys(*document_);
}

void Workbench::show_document() {
    read_document();
    description_ = animation() != nullptr && frame_ ? scene_at(*parsed_, *frame_) : parsed_->description;
    session_->edit(description_);
}

const Animation* Workbench::animation() const {
    return parsed_ && parsed_->animation.scene ? &parsed_->animation : nullptr;
}

void Workbench::show_at(double frame) {
    frame_ = frame;
    description_ = scene_at(*parsed_, frame);
    session_->edit(description_);
    const auto moves_camera = [](const std::string& key) { return key.rfind("camera.", 0) == 0; };
    const std::vector<std::string>& keys = animation()->keys;
    if (description_.camera && std::any_of(keys.begin(), keys.end(), moves_camera))
        session_->move([&](CameraControl& c) { c.set_camera(*description_.camera, c.target_distance()); });
}

std::vector<std::string> Workbench::animated() const {
    if (animation() == nullptr || !frame_) return {};
    std::vector<std::string> keys = animation()->keys;
    for (std::string& key : keys) key = named_key(description_, key);
    return keys;
}

const std::vector<Diagnostic>& Workbench::problems() const {
    return refused_.empty() ? status_.problems : refused_;
}

void Workbench::edit(const std::vector<Edit>& edits, bool same_gesture) {
    if (edits.empty() || !document_) return;
    std::vector<Override> values;
    for (const Edit& edit : edits) values.push_back(edit.path + "=" + edit.value);
    const SceneDocument before = *document_;
    try {
        document_->set_all(values);
        show_document();
        refused_.clear();
    } catch (const Error& error) {
        document_ = before;
        keys_ = FileKeys(*document_);
        refused_ = error.diagnostics();
        return;
    }
    if (!same_gesture || undo_.empty()) undo_.push_back(before);
    if (undo_.size() > max_undo) undo_.erase(undo_.begin());
    redo_.clear();
}

void Workbench::step(std::vector<SceneDocument>& from, std::vector<SceneDocument>& to) {
    if (from.empty()) return;
    to.push_back(*document_);
    // The file may have been saved since that step.
    from.back().take_saved(*document_);
    document_ = std::move(from.back());
    from.pop_back();
    show_document();
}

void Workbench::undo() { step(undo_, redo_); }

void Workbench::redo() { step(redo_, undo_); }

std::string Workbench::save() {
    const std::string name = document_->name();
    if (!is_scene_file(shown_->path) && !is_mesh_saved_) {
        if (std::filesystem::exists(name))
            throw Error(ErrorKind::output,
                        name + " exists already: move it away, or open it instead of the mesh");
        document_->save_as(name);
        is_mesh_saved_ = true;
    } else {
        document_->save();
    }
    return name;
}

void Workbench::keep() {
    kept_ = shown_file(ViewSlot::main);
    if (session_->is_comparing()) session_->compare(kept_->description);
}

void Workbench::compare(bool on) {
    on = on && kept_.has_value();
    if (on != session_->is_comparing())
        session_->compare(on ? std::optional(kept_->description) : std::nullopt);
}

ShownFile Workbench::shown_file(ViewSlot slot) const {
    if (slot == ViewSlot::reference) return kept_.value_or(ShownFile());
    ShownFile shown{is_mesh_saved_ ? document_->name() : file_, load_, document_, {}, frame_, description_};
    if (animation() != nullptr) shown.animated = animation()->keys;
    return shown;
}

} // namespace glint::viewer
