#pragma once
// The [[animate]] tables of a scene file: what moves, and what it has at a frame.

#include "formats/scene/key_table.h"
#include "formats/scene/read.h"
#include "formats/scene/tree.h"
#include "scene/animation.h"

#include <string>
#include <vector>

namespace glint {

/// One value that moves.
struct Track {
    std::string path; ///< of its key, as written
    SourcePos where;  ///< of the path
    KeyType type = KeyType::number;
    Timeline timeline;
    std::vector<TreeValue> values; ///< one for each of timeline.frames; all of one form unless they step
};

struct Tracks {
    int first = 0;
    int last = 0;
    double fps = 24;
    std::vector<Track> tracks;
};

/// Reads [animation] and [[animate]]. Reports what is wrong with them, paths that lead nowhere and values
/// that their keys cannot have.
Tracks read_tracks(const TreeValue& root, Problems& problems);

/// The value of a track at a frame; it stands where the keyframe at or before it does.
TreeValue value_at(const Track& track, double frame);

} // namespace glint
