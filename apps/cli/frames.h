#pragma once
// --frames and --frame: which frames of an animation, and what their files are called.

#include "arguments.h"

#include "glint/formats.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// --frames: "0..119", "0..119:2", "30" or "all".
struct FrameRange {
    bool all = false; ///< what the scene's [animation] says
    int first = 0;
    int last = 0;
    int step = 1;

    /// One frame that was named as such: its file needs no number.
    bool single() const { return !all && first == last; }
    std::vector<int> of(const Animation& animation) const;
};

/// None where the option is not given. Throws Error(usage).
std::optional<FrameRange> frame_range(const Arguments& arguments);

/// A name with the frame's number in place of %d or %04d. `%%` is a percent sign. Throws Error(usage) for any
/// other %.
std::string frame_name(const std::string& pattern, int frame);

/// Does the name have a place for the frame's number? Throws as frame_name().
bool has_frame_number(const std::string& pattern);

/// The scene as it stands, or with --frame as it is at that frame.
SceneDescription at_frame(const Arguments& arguments, const LoadedScene& loaded);

} // namespace glint::cli
