#pragma once
// A scene file held open, to be read as it stands or at a frame of its animation.

#include "formats/scene/animation_tracks.h"
#include "formats/scene/meshes.h"
#include "formats/scene/tree.h"
#include "glint/formats.h"

#include <mutex>
#include <string>

namespace glint {

class OpenScene {
  public:
    /// Throws Error(input) at the text's first syntax error.
    OpenScene(std::string text, std::string name, const LoadOptions& options);

    /// The scene without its animation, which is checked; `animation.scene` is left out.
    LoadedScene load();
    /// The scene at a frame: tracks first, then overrides, which have the last word. Meshes that were read
    /// before are the same objects. Any number of threads may ask.
    SceneDescription at(double frame) const;

  private:
    ReadScene read(const TreeValue& root, Problems& problems, std::vector<Diagnostic>& warnings,
                   std::vector<std::string>& files) const;

    std::string text_;
    std::string name_;
    LoadOptions options_;
    SceneSource source_;
    TreeValue tree_; ///< before overrides
    Tracks tracks_;
    mutable std::mutex mutex_; ///< of meshes_
    mutable MeshCache meshes_;
};

} // namespace glint
