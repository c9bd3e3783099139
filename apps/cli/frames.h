#pragma once
// --frames and --frame: frames of an animation and the names of their files.

#include "arguments.h"

#include "glint/scene_files.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// --frames: "0..119", "0..119:2", "30" or "all".
struct FrameRange {
    bool all = false; ///< the range of the scene's [animation]
    int first = 0;
    int last = 0;
    int step = 1;

    /// A single frame: its file needs no number.
    bool single() const { return !all && first == last; }
    std::vector<int> of(const Animation& animation) const;
};

/// None without the option. Throws Error(usage).
std::optional<FrameRange> frame_range(const Arguments& arguments);

/// Replaces %d or %04d by the frame's number and %% by a percent sign. Throws Error(usage) for any other %.
std::string frame_name(const std::string& pattern, int frame);

/// Does the name contain %d or %04d? Throws as frame_name().
bool has_frame_number(const std::string& pattern);

/// The scene at the frame of --frame, or without animation.
SceneDescription at_frame(const Arguments& arguments, const LoadedScene& loaded);

} // namespace glint::cli
