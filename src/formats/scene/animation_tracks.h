#pragma once
// The [[animate]] tables of a scene file, and their values at a frame.

#include "formats/scene/key_table.h"
#include "formats/scene/read.h"
#include "formats/scene/tree.h"
#include "scene/animation.h"

#include <string>
#include <vector>

namespace glint::formats {

/// An animated value.
struct Track {
    std::string path; ///< key path as written
    SourcePos where;  ///< of the path
    KeyType type = KeyType::number;
    scene::Timeline timeline;
    /// one for each of timeline.frames; all of the same structure unless stepped
    std::vector<TreeValue> values;
};

struct Tracks {
    int first = 0;
    int last = 0;
    double fps = 24;
    std::vector<Track> tracks;
};

/// Reads [animation] and [[animate]]. Reports errors in them, invalid paths, and values that their keys do
/// not accept.
Tracks read_tracks(const TreeValue& root, Problems& problems);

/// The value of a track at a frame; its position is that of the keyframe at or before it.
TreeValue value_at(const Track& track, double frame);

} // namespace glint::formats
