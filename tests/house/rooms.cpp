// The table of rooms, that of headers of other projects, and the check of includes.

#include "rooms.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace glint::house {

const std::vector<Room>& rooms() {
    static const std::vector<Room> table = {
        {"errors", 0, {}},
        {"math", 0, {}},
        {"parallel", 0, {}},
        {"geometry", 1, {"math"}},
        {"bvh", 1, {"math", "parallel"}},
        {"imaging", 1, {"errors", "math"}},
        {"trace", 2, {"math", "parallel", "geometry", "bvh"}},
        {"shading", 2, {"math", "geometry", "imaging"}},
        {"scene", 3, {"errors", "math", "parallel", "geometry", "bvh", "imaging", "trace", "shading"}},
        {"render",
         4,
         {"errors", "math", "parallel", "geometry", "bvh", "imaging", "trace", "shading", "scene"}},
        {"formats",
         4,
         {"errors", "math", "parallel", "geometry", "bvh", "imaging", "trace", "shading", "scene"}},
        {"gpu",
         5,
         {"errors", "math", "parallel", "geometry", "bvh", "imaging", "trace", "shading", "scene", "render"}},
    };
    return table;
}

namespace {

/// Headers of other projects and systems: who may include them, and whether headers of ours may.
struct Foreign {
    std::string prefix;
    std::vector<std::string> users; ///< rooms and "apps"; empty: all
    bool in_headers = false;
};

const std::vector<Foreign>& foreign_headers() {
    static const std::vector<Foreign> table = {
        {"glm/", {}, true},
        {"cpuid.h", {"trace"}, false},
        {"dlfcn.h", {"gpu"}, false},
        {"hwy/", {"math", "trace", "shading", "render"}, true},
        {"fmt/", {"scene", "render", "formats", "apps"}, false},
        {"toml++/", {"formats"}, false},
        {"nlohmann/", {"formats", "apps"}, false},
        {"xxhash.h", {"imaging"}, false},
        {"OpenEXR/", {"formats"}, false},
        {"Imath/", {"formats"}, false},
        {"Imf", {"formats"}, false},
        {"Imath", {"formats"}, false},
        {"Iex", {"formats"}, false},
        {"png.h", {"formats"}, false},
        {"zlib.h", {"formats"}, false},
        {"CLI/", {"apps"}, false},
        {"thread", {"parallel", "apps"}, false},
        {"GLFW/", {"apps"}, false},
        {"epoxy/", {"gpu", "apps"}, false},
        {"imgui.h", {"apps"}, false},
        {"backends/", {"apps"}, false},
        {"iostream", {"formats", "apps"}, false},
        {"unistd.h", {"formats", "apps"}, false},
        {"fcntl.h", {"formats", "apps"}, false},
        {"sys/", {"parallel", "render", "formats", "apps"}, false},
        {"pthread.h", {"parallel"}, false},
        {"sched.h", {"parallel"}, false},
    };
    return table;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The n-th part of a path, from 0; empty if there is none.
std::string part(const std::string& path, int n) {
    std::size_t begin = 0;
    for (; n > 0; --n) {
        begin = path.find('/', begin);
        if (begin == std::string::npos) return {};
        ++begin;
    }
    return path.substr(begin, path.find('/', begin) - begin);
}

const Room* find_room(const std::string& name) {
    for (const Room& room : rooms())
        if (room.name == name) return &room;
    return nullptr;
}

/// The room a file belongs to, or "apps"; empty for an unknown one.
std::string owner_of(const std::string& path) {
    if (part(path, 0) == "apps") return "apps";
    if (part(path, 0) == "include") return room_of_public_header(path.substr(std::string("include/").size()));
    return find_room(part(path, 1)) != nullptr ? part(path, 1) : "";
}

/// Why the file may not include a header given in brackets; empty if it may.
std::string against_foreign(const Source& source, const std::string& owner, const std::string& name) {
    for (const Foreign& foreign : foreign_headers()) {
        // A prefix ending in '/' or one of a family of files stands for all of them, any other for itself.
        const bool family = foreign.prefix.back() == '/' || foreign.prefix.starts_with("I");
        if (family ? !name.starts_with(foreign.prefix) : name != foreign.prefix) continue;
        if (!foreign.users.empty() && !contains(foreign.users, owner))
            return "<" + name + "> is not for " + owner;
        if (source.path.ends_with(".h") && !foreign.in_headers)
            return "<" + name + "> belongs in a .cpp, not in a header";
        return {};
    }
    if (name.find_first_of("./") != std::string::npos)
        return "<" + name + "> is no standard header and not in the table of foreign ones";
    return {};
}

/// Does a relative name, seen from a file of apps/cli, lead to a file of apps/cli or apps/common?
bool stays_in_program(const std::string& path, const std::string& name) {
    const std::filesystem::path target =
        (std::filesystem::path(path).parent_path() / name).lexically_normal();
    const std::string program = part(path, 0) + "/" + part(path, 1) + "/";
    const std::string found = target.generic_string();
    return find_room(part(name, 0)) == nullptr &&
           (found.starts_with(program) || found.starts_with("apps/common/"));
}

/// Why a file may not include one of our headers; empty if it may.
std::string against_own(const Source& source, const std::string& owner, const std::string& name) {
    const bool is_public = name.starts_with("glint/");
    if (owner == "apps") {
        if (is_public || stays_in_program(source.path, name)) return {};
        return "programs use public headers and their own, not \"" + name + "\"";
    }
    const std::string other = is_public ? room_of_public_header(name) : part(name, 0);
    if (find_room(other) == nullptr || name.find('/') == std::string::npos)
        return "\"" + name + "\" names no room; write it as \"room/file.h\"";
    if (!is_public && part(source.path, 0) == "include")
        return "a public header includes the private \"" + name + "\"";
    if (other == owner || contains(find_room(owner)->below, other)) return {};
    return owner + " may not include " + other + ": \"" + name + "\"";
}

} // namespace

std::string namespace_of(const std::string& room) {
    if (room == "errors" || room == "math") return "glint";
    return "glint::" + (room == "render" ? "rendering" : room); // glint::render() is a public function
}

std::string room_of_public_header(const std::string& name) {
    static const std::map<std::string, std::string> owners = {
        {"glint/error.h", "errors"},
        {"glint/scene.h", "scene"},
        {"glint/image.h", "imaging"},
        {"glint/formats.h", "formats"},
        {"glint/render.h", "render"},
        {"glint/trace.h", "trace"},
        {"glint/kernels.h", "trace"},
        {"glint/document.h", "formats"},
        {"glint/term.h", "scene"},
        {"glint/explanation.h", "scene"},
        {"glint/explain.h", "render"},
        {"glint/progressive.h", "render"},
        {"glint/pick.h", "render"},
        {"glint/gpu.h", "gpu"},
        {"glint/enum_names.h", "imaging"},
        {"glint/limits.h", "scene"},
        {"glint/filter.h", "imaging"},
        {"glint/fov_axis.h", "imaging"},
        {"glint/scene_files.h", "formats"},
        {"glint/mesh_files.h", "formats"},
        {"glint/picture_files.h", "formats"},
        {"glint/explanation_files.h", "formats"},
        {"glint/keys.h", "scene"},
        {"glint/write_file.h", "formats"},
    };
    const auto found = owners.find(name);
    return found == owners.end() ? "" : found->second;
}

std::vector<std::string> complaints(const Source& source) {
    std::vector<std::string> out;
    const std::string owner = owner_of(source.path);
    if (owner.empty()) return {source.path + ":1: belongs to no room of the table"};
    for (const Include& include : includes_of(source.text)) {
        const std::string why = include.angled ? against_foreign(source, owner, include.name)
                                               : against_own(source, owner, include.name);
        if (!why.empty()) out.push_back(source.path + ":" + std::to_string(include.line) + ": " + why);
    }
    return out;
}

namespace {

/// Depth-first search for a cycle among the files that include each other.
class CycleSearch {
  public:
    explicit CycleSearch(const std::vector<Source>& sources) {
        for (const Source& source : sources)
            for (const Include& include : includes_of(source.text)) {
                if (include.angled) continue;
                const std::string folder = source.path.substr(0, source.path.rfind('/') + 1);
                for (const std::string& base : {std::string("src/"), std::string("include/"), folder})
                    edges_[source.path].push_back(base + include.name);
            }
    }

    std::vector<std::string> run() {
        for (const auto& [path, targets] : edges_)
            if (visit(path)) return path_;
        return {};
    }

  private:
    bool visit(const std::string& file) {
        const bool open = contains(path_, file);
        path_.push_back(file);
        if (open) {
            path_.erase(path_.begin(), std::find(path_.begin(), path_.end(), file));
            return true;
        }
        if (done_.count(file) == 0)
            for (const std::string& target : edges_[file])
                if (edges_.count(target) != 0 && visit(target)) return true;
        done_.insert(file);
        path_.pop_back();
        return false;
    }

    std::map<std::string, std::vector<std::string>> edges_;
    std::set<std::string> done_;
    std::vector<std::string> path_; ///< the files being followed, outermost first
};

} // namespace

std::vector<std::string> include_cycle(const std::vector<Source>& sources) {
    return CycleSearch(sources).run();
}

} // namespace glint::house
