#pragma once
// The options of `glint render`, read and checked before the scene is.

#include "arguments.h"
#include "frames.h"
#include "outputs.h"

#include "glint/picture_files.h"
#include "glint/render.h"
#include "glint/scene_files.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// What the command line asks for, beyond the scene itself.
struct RenderRequest {
    std::string scene;
    std::string output;               ///< a pattern of frame_name() for several frames
    std::optional<FrameRange> frames; ///< none: the scene as it stands
    std::optional<std::string> stats;
    LoadOptions load;
    RenderOptions render;
    View view = View::srgb;
    int bits = 8;
    bool keep_partial = false;
    bool dry_run = false;
};

/// Throws Error(usage) for all that can be told to be wrong without the scene, and Error(output) where a
/// result could not be written.
RenderRequest read_render_request(const Arguments& arguments);

/// All that is written for these frames; for none, if --frames is not given.
std::vector<Output> outputs(const RenderRequest& request, const std::vector<int>& frames);

/// --size, --spp and their like override what the scene says. Throws Error(usage).
void apply_flags(const Arguments& arguments, SceneDescription& scene);

/// Throws Error(usage) where --crop holds no pixel or leaves the picture.
void require_crop_inside(const RenderSettings& settings, const std::optional<Rect>& crop);

/// Bytes that a render takes beside the description of its scene, estimated.
struct MemoryNeeds {
    double scene = 0; ///< at most, while its trees are built
    double picture = 0;
    double writing = 0;
    double total() const { return scene + picture + writing; }
};
MemoryNeeds memory_needs(const RenderRequest& request, const SceneDescription& scene);

} // namespace glint::cli
