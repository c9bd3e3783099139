#pragma once
// Scene files that programs edit: values change where they stand, everything else keeps its bytes.

#include "glint/formats.h"
#include "glint/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// The text of a scene file, and the values that were set in it. Key paths are those of -D:
/// "material.glass.index", "light.0.intensity", "camera.eye", "mesh.cat.transform.0.angle". A plain value:
/// copies are independent, so that keeping one is all that undo takes.
class SceneDocument {
  public:
    /// A document of that text; `name` stands for the file in messages, and its folder for relative names.
    /// Throws Error(input) where the text is no TOML.
    SceneDocument(std::string text, std::string name);

    /// Reads a scene file. A bare mesh becomes a new document that stages it, named like the mesh with
    /// ".toml", of which changed() is true; `options` say how it is staged. Throws what load_scene() throws.
    static SceneDocument open(const std::string& path, const LoadOptions& options = {});

    const std::string& text() const { return text_; }
    const std::string& name() const { return name_; }
    /// Does the text differ from the file as it was opened or saved last?
    bool changed() const { return saved_ != text_; }
    /// Is that the text of the file, as it was opened or saved last?
    bool is_saved_as(std::string_view text) const { return saved_ == text; }
    /// Going back to a copy made before `now` was saved: the file is as `now` knows it, and the text is the
    /// copy's.
    void take_saved(const SceneDocument& now) { saved_ = now.saved_; }
    /// What was set since then, each key once, as -D has it: given beside that file it says what the text
    /// says.
    std::vector<Override> changes() const;

    /// The value at the path as it is written; none where the file leaves it out or has no such table.
    std::optional<std::string> value(std::string_view path) const;

    /// The numbers of the value at the path: one, or those of its list. Empty where it is no such thing.
    std::vector<double> numbers(std::string_view path) const;
    /// The list at the path as it is written, with one more value at its end, for set(). None where it stands
    /// under headers of its own.
    std::optional<std::string> longer_list(std::string_view path, std::string_view value) const;

    /// Sets a value, given as after -D: TOML, or else text. Replaces the characters of the value where the
    /// key exists, and else writes the key into its table; [camera], [render], [whitted] and [animation] are
    /// added where they lack. What is set back to what the file said gets the file's own characters. The
    /// scene is checked without reading its meshes; throws Error(input) as -D would, and changes nothing
    /// then.
    void set(std::string_view path, std::string_view value);
    void set(std::string_view path, const char* value) { set(path, std::string_view(value)); }
    /// The shortest text that reads back as exactly this value.
    void set(std::string_view path, double value);
    void set(std::string_view path, const Vec3& value);
    void set(std::string_view path, int value);
    void set(std::string_view path, bool value);
    /// Sets several at once, "path=value" each, in order: what is wrong in between does not matter.
    void set_all(const std::vector<Override>& values);
    /// Sets what differs from the scene's camera. What it looks at is written as look_at or direction, as the
    /// file has it; look_at is eye + direction, rounded.
    void set_camera(const CameraDescription& camera);

    /// Takes the file's text as it is now, with the values set here put in again. Throws Error(input) where
    /// one has no place any more, and changes nothing then.
    void rebase(std::string text);

    /// Writes the file, whole or not at all. What others changed in it since it was opened is kept: the
    /// values set here go into the file as it is now. A staged mesh overwrites no file: Error(output). Throws
    /// as rebase() and write_file().
    void save();
    /// Writes to another file, over what is there, and stays with it. Mesh files are named as seen from
    /// there.
    void save_as(const std::string& path);

  private:
    struct Edit {
        std::string path;   ///< as given
        std::string target; ///< as KeyTarget::path
        std::string value;
        std::optional<std::string> original; ///< the characters in the file; none: the key was absent
    };

    void put(std::string_view path, std::string_view value);

    std::string name_;
    std::string text_;
    std::optional<std::string> saved_; ///< the text in the file, as far as known; none: no file yet
    std::vector<Edit> edits_;          ///< since then
};

/// A document for the scene in which load_scene() shows a bare mesh: named like the mesh with ".toml", the
/// mesh named by its file in the same folder.
SceneDocument preview_document(SceneDescription scene, const std::string& mesh);

/// A value as scene files write it, the shortest that reads back as the same: "0.1", "[1, 2, 3]", "\"text\"".
std::string scene_value(double value);
std::string scene_value(const Vec3& value);
std::string scene_value(std::string_view value);

/// A scene file that says what the description says. Values that are the defaults are left out. Meshes are
/// named by MeshShape::file; one without cannot be written: Error(output).
std::string scene_text(const SceneDescription& description);

/// The [camera] table of a camera, for pasting into a scene file.
std::string camera_text(const CameraDescription& camera);

} // namespace glint
