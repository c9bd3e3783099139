#pragma once
// Editing scene files: values are changed in place, all other bytes of the file are kept.

#include "glint/scene.h"
#include "glint/scene_files.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// The text of a scene file and the edits made to it. Key paths are those of -D, such as
/// "material.glass.index", "light.0.intensity", "camera.eye" or "mesh.cat.transform.0.angle". A plain value:
/// copies are independent, so an undo history is a list of copies.
class SceneDocument {
  public:
    /// Makes a document from text; `name` is the file name for messages, and its folder resolves relative
    /// names. Throws Error(input) if the text is not valid TOML.
    SceneDocument(std::string text, std::string name);

    /// Reads a scene file. A bare mesh becomes a new document with a preview scene, named like the mesh with
    /// ".toml", for which changed() is true; `options` apply to the preview. Throws what load_scene() throws.
    static SceneDocument open(const std::string& path, const LoadOptions& options = {});

    const std::string& text() const { return text_; }
    const std::string& name() const { return name_; }
    /// Whether the text differs from the file as opened or last saved.
    bool changed() const { return saved_ != text_; }
    /// Whether `text` is the file as opened or last saved.
    bool is_saved_as(std::string_view text) const { return saved_ == text; }
    /// For undo: keeps the text of this copy but takes the saved state of the file from `now`, a later copy.
    void take_saved(const SceneDocument& now) { saved_ = now.saved_; }
    /// Edits since then, one per key, as arguments of -D: the file with these overrides has the values of
    /// this text.
    std::vector<Override> changes() const;

    /// The value at the path as written in the file; none if the key or its table is missing.
    std::optional<std::string> value(std::string_view path) const;

    /// The numbers at the path: one, or those of a list. Empty if the value is something else.
    std::vector<double> numbers(std::string_view path) const;
    /// The list at the path as written, with one more value appended, for use with set(). None if the list is
    /// an array of tables with headers.
    std::optional<std::string> longer_list(std::string_view path, std::string_view value) const;

    /// Sets a value, given as for -D: TOML, otherwise text. Replaces the characters of an existing value, or
    /// adds the key to its table; missing tables [camera], [render], [whitted] and [animation] are added.
    /// Setting the file's original value restores its original characters. The scene is checked without
    /// reading meshes; throws Error(input) as -D would and then changes nothing.
    void set(std::string_view path, std::string_view value);
    void set(std::string_view path, const char* value) { set(path, std::string_view(value)); }
    /// Sets the shortest text that parses to exactly this value.
    void set(std::string_view path, double value);
    void set(std::string_view path, const Vec3& value);
    void set(std::string_view path, int value);
    void set(std::string_view path, bool value);
    /// Sets several "path=value" in order; the scene is checked only after the last.
    void set_all(const std::vector<Override>& values);
    /// Sets the keys in which the camera differs from the scene's. The target is written as look_at or
    /// direction as in the file; look_at is eye + direction, rounded.
    void set_camera(const CameraDescription& camera);

    /// Replaces the text by the current text of the file and applies the edits again. Throws Error(input) if
    /// an edit no longer applies, and then changes nothing.
    void rebase(std::string text);

    /// Writes the file atomically. Changes that others made to it since it was opened are kept: the edits are
    /// applied to its current text. Does not overwrite the mesh file of a preview scene: Error(output).
    /// Throws what rebase() and write_file() throw.
    void save();
    /// Writes to another file, replacing it, and continues with that file. Mesh files are renamed relative to
    /// it.
    void save_as(const std::string& path);

  private:
    struct Edit {
        std::string path;   ///< as given
        std::string target; ///< as KeyTarget::path
        std::string value;
        std::optional<std::string> original; ///< original text in the file; none if the key was absent
    };

    void put(std::string_view path, std::string_view value);

    std::string name_;
    std::string text_;
    std::optional<std::string> saved_; ///< last known text of the file; none if there is no file yet
    std::vector<Edit> edits_;          ///< edits since then
};

/// A document for the scene in which load_scene() shows a bare mesh: named like the mesh with ".toml", the
/// mesh named by its file in the same folder.
SceneDocument preview_document(SceneDescription scene, const std::string& mesh);

/// A value as written in scene files, in the shortest form that parses to the same value: "0.1", "[1, 2, 3]",
/// "\"text\"".
std::string scene_value(double value);
std::string scene_value(const Vec3& value);
std::string scene_value(std::string_view value);

/// A scene file with the contents of a description. Default values are omitted. Meshes are referred to by
/// MeshShape::file; throws Error(output) if a mesh has none.
std::string scene_text(const SceneDescription& description);

/// The [camera] table of a camera, to paste into a scene file.
std::string camera_text(const CameraDescription& camera);

} // namespace glint
