// SceneDocument: locates values in the text and keeps their original characters.

#include "glint/document.h"

#include "formats/read_text.h"
#include "formats/scene/document_edit.h"
#include "glint/scene.h"
#include "glint/write_file.h"

#include <algorithm>
#include <filesystem>
#include <span>

namespace glint {

using formats::parse_tree_value;
using formats::SceneSource;
using formats::text_of;
using formats::TreeEntry;
using formats::TreeValue;

namespace {

namespace fs = std::filesystem;

std::string path_and(std::string_view path, std::string_view value) {
    return std::string(path) + "=" + std::string(value);
}

/// The value in TOML syntax: as given without a trailing comment, or as a quoted string.
std::string as_toml(std::string_view given) {
    const std::string_view value = formats::trimmed(given);
    const auto tree = parse_tree_value(value, {});
    if (!tree) return scene_value(value);
    return std::string(value.substr(0, SceneSource(value, {}, {}).offset(tree->end)));
}

/// A parsed text.
struct Parsed {
    SceneSource source;
    formats::Problems problems;
    TreeValue root;

    Parsed(const std::string& text, const std::string& name, std::vector<Override> overrides)
        : source(text, name, std::move(overrides)), problems(source), root(formats::parse_tree(source)) {}
    Parsed(const Parsed&) = delete;
    Parsed& operator=(const Parsed&) = delete;
};

constexpr formats::SourcePos first_override{1, 0, 0};

/// Whether files may be read is for those who read them.
LoadOptions without_files(std::vector<Override> overrides = {}) {
    return {.overrides = std::move(overrides), .allow_outside = true, .load_meshes = false};
}

/// The value at a path; null if there is none.
const TreeValue* value_at(Parsed& parsed, std::string_view path) {
    const formats::KeyTarget target =
        formats::KeyPaths(parsed.root, parsed.problems).find(path, first_override);
    const TreeEntry* entry = target.table ? target.table->find(target.key) : nullptr;
    return entry ? &entry->value : nullptr;
}

fs::path folder_of(const std::string& file) { return fs::weakly_canonical(fs::absolute(file).parent_path()); }

} // namespace

SceneDocument::SceneDocument(std::string text, std::string name)
    : name_(std::move(name)), text_(std::move(text)), saved_(text_) {
    formats::parse_tree(SceneSource(text_, name_, {}));
}

SceneDocument SceneDocument::open(const std::string& path, const LoadOptions& options) {
    if (formats::lower_extension(path) != ".ply") {
        std::string text = formats::read_text(path);
        if (!formats::looks_like_ply(text))
            return {std::move(text), path == "-" ? formats::stdin_name : path};
        if (path == "-")
            throw Error(ErrorKind::input, "a mesh from stdin has no scene file to edit", "name its file");
    }
    SceneDocument document = preview_document(load_scene(path, options).description, path);
    document.saved_.reset();
    return document;
}

std::optional<std::string> SceneDocument::value(std::string_view path) const {
    Parsed parsed(text_, name_, {Override(path)});
    const TreeValue* value = value_at(parsed, path);
    return value ? std::optional(std::string(text_of(parsed.source, *value))) : std::nullopt;
}

std::vector<double> SceneDocument::numbers(std::string_view path) const {
    Parsed parsed(text_, name_, {Override(path)});
    const TreeValue* value = value_at(parsed, path);
    if (!value) return {};
    if (value->is_number()) return {value->number};
    if (!std::ranges::all_of(value->items, &TreeValue::is_number)) return {};
    std::vector<double> all;
    for (const TreeValue& item : value->items) all.push_back(item.number);
    return all;
}

std::optional<std::string> SceneDocument::longer_list(std::string_view path, std::string_view value) const {
    Parsed parsed(text_, name_, {Override(path)});
    const TreeValue* list = value_at(parsed, path);
    const std::string added(value);
    if (!list) return "[" + added + "]";
    std::string text(text_of(parsed.source, *list));
    if (!text.starts_with('[') || text.starts_with("[[") || list->kind != TreeValue::Kind::list)
        return std::nullopt;
    if (list->items.empty()) return "[" + added + "]";
    // Insert after the last value, before its comment.
    const std::size_t begin = parsed.source.offset(list->where);
    return text.insert(parsed.source.offset(list->items.back().end) - begin, ", " + added);
}

std::vector<Override> SceneDocument::changes() const {
    std::vector<Override> all;
    for (const Edit& edit : edits_) all.push_back(path_and(edit.path, edit.value));
    return all;
}

void SceneDocument::set(std::string_view path, std::string_view value) { set_all({path_and(path, value)}); }
void SceneDocument::set(std::string_view path, double value) { set(path, scene_value(value)); }
void SceneDocument::set(std::string_view path, const Vec3& value) { set(path, scene_value(value)); }
void SceneDocument::set(std::string_view path, int value) { set(path, std::to_string(value)); }
void SceneDocument::set(std::string_view path, bool value) { set(path, value ? "true" : "false"); }

void SceneDocument::set_all(const std::vector<Override>& values) {
    parse_scene(text_, name_, without_files(values));

    SceneDocument next = *this;
    for (const Override& each : values) {
        const std::size_t equals = each.find('=');
        next.put(std::string_view(each).substr(0, equals), std::string_view(each).substr(equals + 1));
    }
    *this = std::move(next);
}

void SceneDocument::put(std::string_view path, std::string_view given) {
    Parsed parsed(text_, name_, {path_and(path, given)});
    const formats::KeyTarget target =
        formats::KeyPaths(parsed.root, parsed.problems).find(path, first_override);
    parsed.problems.throw_if_any();
    std::string value = as_toml(given);
    const TreeValue wanted = *parse_tree_value(value, first_override);
    const TreeEntry* entry = target.table->find(target.key);
    if (entry && formats::same_value(entry->value, wanted)) return;

    auto edit = std::find_if(edits_.begin(), edits_.end(),
                             [&](const Edit& each) { return each.target == target.path; });
    bool as_it_was = false;
    if (edit != edits_.end() && edit->original) {
        const auto original = parse_tree_value(*edit->original, first_override);
        as_it_was = original && formats::same_value(*original, wanted);
    }
    const formats::TextEdit change =
        formats::edit_for(parsed.source, parsed.root, target, as_it_was ? *edit->original : value);

    // A value set back to the original needs no edit; edits of sub-keys are superseded.
    if (edit == edits_.end()) {
        std::optional<std::string> original;
        if (entry) original = text_of(parsed.source, entry->value);
        edits_.push_back({std::string(path), target.path, std::move(value), std::move(original)});
    } else
        edit->value = std::move(value);
    std::erase_if(edits_, [&](const Edit& each) {
        return each.target.starts_with(target.path + ".") || (as_it_was && each.target == target.path);
    });

    const std::size_t mark = text_.size() - parsed.source.text().size(); // of the byte order
    text_.replace(mark + change.begin, change.end - change.begin, change.text);
}

void SceneDocument::set_camera(const CameraDescription& camera) {
    const auto now = parse_scene(text_, name_, without_files()).description.camera;
    std::vector<Override> values;
    const auto set_key = [&](const char* key, const std::string& value) {
        values.push_back(path_and(std::string("camera.") + key, value));
    };
    if (!now || now->eye != camera.eye) set_key("eye", scene_value(camera.eye));
    if (value("camera.direction")) {
        if (now->direction != camera.direction) set_key("direction", scene_value(camera.direction));
    } else if (!now || now->eye != camera.eye || now->direction != camera.direction)
        set_key("look_at", scene_value(camera.eye + camera.direction));
    const CameraDescription before = now.value_or(CameraDescription{});
    if (before.up != camera.up) set_key("up", scene_value(camera.up));
    if (before.fov != camera.fov) set_key("fov", scene_value(camera.fov));
    if (before.fov_axis != camera.fov_axis) set_key("fov_axis", scene_value(name_of(camera.fov_axis)));
    set_all(values);
}

void SceneDocument::rebase(std::string text) {
    SceneDocument next(std::move(text), name_);
    next.set_all(changes());
    *this = std::move(next);
}

void SceneDocument::save() {
    if (name_ == formats::stdin_name)
        throw Error(ErrorKind::usage, "a scene from stdin has no file to be saved in", "name one");
    std::error_code ignored;
    if (fs::exists(name_, ignored)) {
        if (!saved_)
            throw Error(ErrorKind::output, "\"" + name_ + "\" exists", "save under another name",
                        {name_, 0, 0, {}});
        std::string found = formats::read_text(name_);
        if (found != *saved_) rebase(std::move(found));
    }
    write_file(name_, std::as_bytes(std::span(text_)));
    saved_ = text_;
    edits_.clear();
}

void SceneDocument::save_as(const std::string& path) {
    SceneDocument next = *this;
    const fs::path from = folder_of(name_), to = folder_of(path);
    const Parsed parsed(text_, name_, {});
    const TreeEntry* meshes = from == to ? nullptr : parsed.root.find("mesh");
    for (std::size_t i = 0; meshes && i < meshes->value.items.size(); ++i) {
        const TreeEntry* file = meshes->value.items[i].find("file");
        if (!file || fs::path(file->value.text).is_absolute()) continue;
        const fs::path seen = (from / file->value.text).lexically_normal().lexically_relative(to);
        next.put("mesh." + std::to_string(i) + ".file", scene_value(seen.generic_string()));
    }
    write_file(path, std::as_bytes(std::span(next.text_)));
    next.name_ = path;
    next.saved_ = next.text_;
    next.edits_.clear();
    *this = std::move(next);
}

SceneDocument preview_document(SceneDescription scene, const std::string& mesh) {
    if (!scene.camera) scene.camera = fit_camera(scene);
    const fs::path path(mesh);
    for (Object& object : scene.objects)
        if (auto* shape = std::get_if<MeshShape>(&object.shape)) shape->file = path.filename().string();
    return {scene_text(scene), fs::path(path).replace_extension(".toml").string()};
}

} // namespace glint
