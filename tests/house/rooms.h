#pragma once
// Which room may include which others, and headers of which other projects.

#include "sources.h"

#include <string>
#include <vector>

namespace glint::house {

/// A folder of src/. It may include its own headers and those of `below`, all on lower floors.
struct Room {
    std::string name;
    int floor = 0;
    std::vector<std::string> below;
};

/// The rooms, lowest floor first. docs/design.md shows the same table.
const std::vector<Room>& rooms();

/// The namespace of the names that a room's headers declare. docs/design.md says the same.
std::string namespace_of(const std::string& room);

/// The room a public header belongs to: "glint/scene.h" → "scene"; empty for an unknown one.
std::string room_of_public_header(const std::string& name);

/// What is wrong with the includes of one file of src/, include/ or apps/: "path:line: why", one each.
std::vector<std::string> complaints(const Source& source);

/// The files of a cycle of includes, the first repeated at the end; empty if there is no cycle.
std::vector<std::string> include_cycle(const std::vector<Source>& sources);

} // namespace glint::house
