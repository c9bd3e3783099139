// Reading a scene at any frame.

#include "formats/scene/open_scene.h"

#include "formats/read_text.h"
#include "formats/scene/key_path.h"
#include "scene/text.h"

#include <set>
#include <utility>

namespace glint::formats {

OpenScene::OpenScene(std::string text, std::string name, const LoadOptions& options)
    : text_(std::move(text)), name_(std::move(name)), options_(options),
      source_(text_, name_, options.overrides), tree_(parse_tree(source_)) {}

ReadScene OpenScene::read(const TreeValue& root, Problems& problems, std::vector<Diagnostic>& warnings,
                          std::vector<std::string>& files) const {
    ReadScene scene = read_scene(root, problems);
    check_scene(scene, problems);
    const std::lock_guard lock(mutex_);
    load_meshes(scene, {name_, options_.allow_outside, options_.load_meshes, options_}, problems, meshes_,
                warnings, files);
    check_mesh_extents(scene, problems);
    problems.throw_if_any();
    return scene;
}

void OpenScene::set_framing(SceneDescription& description, const std::optional<TreeValue>& set,
                            Problems& problems) const {
    description.framing.moments = moments_;
    if (set) patch_framing(*set, description, problems);
    problems.throw_if_any();
}

namespace {

bool stays(const Object& a, const Object& b) {
    return a.transform == b.transform && a.visible == b.visible && a.shape == b.shape;
}

// Meshes that do not move need not be measured again at each moment.
void hide_what_stays(SceneDescription& moment, const SceneDescription& still) {
    for (std::size_t i = 0; i < moment.objects.size(); ++i)
        if (std::holds_alternative<MeshShape>(moment.objects[i].shape) &&
            stays(moment.objects[i], still.objects[i]))
            moment.objects[i].visible = false;
}

} // namespace

// One camera for all frames, so that what moves is seen to move: all of them are framed, or that many.
void OpenScene::find_moments(const SceneDescription& still) {
    constexpr int most = 64;
    auto moments = std::make_shared<std::vector<SceneDescription>>(1, still);
    for (int i = 0; i <= most; ++i) {
        const double frame = tracks_.first + double(tracks_.last - tracks_.first) * i / most;
        try {
            moments->push_back(at(frame));
            hide_what_stays(moments->back(), still);
        } catch (const Error&) {
            continue; // said where this frame is asked for
        }
    }
    moments_ = std::move(moments);
}

namespace {

// The tracks have them: the tree of a frame need not copy them.
void drop_keyframes(TreeValue& root) {
    TreeEntry* tracks = root.find("animate");
    if (!tracks) return;
    for (TreeValue& track : tracks->value.items)
        std::erase_if(track.entries,
                      [](const TreeEntry& entry) { return entry.key == "frames" || entry.key == "values"; });
}

} // namespace

LoadedScene OpenScene::load() {
    Problems problems(source_);
    has_camera_ = tree_.find("camera") != nullptr;
    // Without animation the tree is read only once.
    TreeValue root = tree_.find("animate") ? tree_ : std::move(tree_);
    apply_overrides(root, source_, problems);
    tracks_ = read_tracks(root, problems);
    drop_keyframes(tree_);
    for (const Track& track : tracks_.tracks)
        has_camera_ = has_camera_ || track.path.rfind("camera.", 0) == 0;
    const std::optional<TreeValue> set = has_camera_ ? std::nullopt : taken_camera(root);

    LoadedScene loaded;
    if (name_ != stdin_name) loaded.files.push_back(name_);
    loaded.description = read(root, problems, loaded.warnings, loaded.files).description;
    const auto own = problems.warnings();
    loaded.warnings.insert(loaded.warnings.begin(), own.begin(), own.end());

    // Later queries must not use the cancel flag of this call.
    options_.cancel = nullptr;
    options_.progress = nullptr;

    if (!has_camera_ && !tracks_.tracks.empty() && options_.load_meshes) find_moments(loaded.description);
    set_framing(loaded.description, set, problems);

    loaded.animation.first = tracks_.first;
    loaded.animation.last = tracks_.last;
    loaded.animation.fps = tracks_.fps;
    std::set<std::string> known(loaded.files.begin(), loaded.files.end());
    for (const Track& track : tracks_.tracks) {
        loaded.animation.keys.push_back(track.path);
        if (track.type != KeyType::file) continue;
        for (const TreeValue& value : track.values) {
            std::string file = mesh_path(name_, value.text, value.where);
            if (known.insert(file).second) loaded.files.push_back(std::move(file));
        }
    }
    return loaded;
}

SceneDescription OpenScene::at(double frame) const {
    Problems problems(source_);
    TreeValue root = tree_;
    KeyPaths paths(root, problems);
    for (const Track& track : tracks_.tracks) {
        const KeyTarget target = paths.find(track.path, track.where);
        if (!target.table) continue;
        TreeValue value = value_at(track, frame);
        const SourcePos where = value.where;
        paths.put(target, std::move(value), where);
    }
    apply_overrides(root, source_, problems);
    const std::optional<TreeValue> set = has_camera_ ? std::nullopt : taken_camera(root);
    std::vector<Diagnostic> warnings;
    std::vector<std::string> files;
    try {
        SceneDescription description = read(root, problems, warnings, files).description;
        set_framing(description, set, problems);
        return description;
    } catch (const Error& error) {
        std::vector<Diagnostic> diagnostics = error.diagnostics();
        for (Diagnostic& diagnostic : diagnostics)
            diagnostic.message = "frame " + scene::show(frame) + ": " + diagnostic.message;
        throw Error(error.kind(), std::move(diagnostics));
    }
}

} // namespace glint::formats
