#pragma once
// A parsed scene file, which can be read as it is or at a frame of its animation.

#include "formats/scene/animation_tracks.h"
#include "formats/scene/load_meshes.h"
#include "formats/scene/tree.h"
#include "glint/scene_files.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace glint::formats {

class OpenScene {
  public:
    /// Throws Error(input) at the text's first syntax error.
    OpenScene(std::string text, std::string name, const LoadOptions& options);

    /// Reads the scene as its tables say and checks its animation; leaves `animation.scene` empty.
    LoadedScene load();
    /// The scene at a frame: tracks are applied first, then overrides, which take precedence. Meshes are
    /// shared with earlier results. May be called by any number of threads.
    SceneDescription at(double frame) const;

  private:
    /// `set`: the values of overrides for a camera that the scene does not have.
    void set_framing(SceneDescription& description, const std::optional<TreeValue>& set,
                     Problems& problems) const;
    void find_moments(const SceneDescription& still);
    ReadScene read(const TreeValue& root, Problems& problems, std::vector<Diagnostic>& warnings,
                   std::vector<std::string>& files) const;

    std::string text_;
    std::string name_;
    LoadOptions options_;
    SceneSource source_;
    TreeValue tree_; ///< before overrides
    Tracks tracks_;
    bool has_camera_ = false;                                      ///< the file has, or animates one
    std::shared_ptr<const std::vector<SceneDescription>> moments_; ///< to frame, see Framing
    mutable std::mutex mutex_;                                     ///< of meshes_
    mutable MeshCache meshes_;
};

} // namespace glint::formats
