#pragma once
// What programs read: --stats, check --json, info --json and info --devices --json. The only part that sees
// the JSON library.

#include "glint/render.h"
#include "glint/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// What one render was and cost.
struct RenderRecord {
    std::string scene;  ///< as named on the command line
    std::string output; ///< likewise
    std::string hash;
    std::optional<int> frame;
    double fraction = 1; ///< of the picture that is done
    double load_seconds = 0;
    double build_seconds = 0;
    double write_seconds = 0;
    std::string device; ///< the graphics card; empty: the CPU
};

/// Rays through the camera that a picture took.
double samples_per_pixel(const Picture& picture);

/// The document of --stats, with a line feed at its end.
std::string stats_json(const RenderRecord& record, const Scene& scene, const Picture& picture);

/// The document of --stats for several pictures: a list of theirs.
std::string stats_list_json(const std::vector<std::string>& documents);

/// The closing line of a picture for --progress json, without a line feed.
std::string picture_event_json(const RenderRecord& record, const Picture& picture);

/// What check finds in one file.
struct CheckedFile {
    std::string file; ///< as named on the command line
    std::vector<Diagnostic> errors;
    std::vector<Diagnostic> warnings;
    std::vector<std::string> notes;
    std::optional<SceneStats> stats; ///< of a file without errors
    std::size_t materials = 0;
};

/// The document of check --json, with a line feed at its end.
std::string check_json(const std::vector<CheckedFile>& files);

/// The document of info --json, with a line feed at its end.
std::string info_json(const std::string& file, const SceneDescription& description, const Scene& scene);

/// The document of info --devices --json: the facts of devices_text().
std::string devices_json();

} // namespace glint::cli
