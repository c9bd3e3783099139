// What memory there is, and what scenes take.

#include "glint/limits.h"
#include "glint/scene.h"
#include "parallel/resources.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <variant>

namespace glint {

double available_memory() { return std::max(0.0, parallel::memory_limit() - parallel::resident_memory()); }

void require_memory(double bytes, const std::string& what, const std::string& hint, const Location& where) {
    const double left = available_memory();
    if (bytes > left)
        throw Error(ErrorKind::resource,
                    what + " takes " + bytes_text(bytes) + " of memory, and " + bytes_text(left) +
                        " are left",
                    hint, where);
}

std::string bytes_text(double bytes) {
    constexpr std::array units{"B", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    for (; bytes >= 1024 && unit + 1 < units.size(); ++unit) bytes /= 1024;
    const int digits = unit == 0 || bytes >= 99.95 ? 0 : 1;
    std::array<char, 32> text{};
    char* const end = std::to_chars(text.begin(), text.end(), bytes, std::chars_format::fixed, digits).ptr;
    return std::string(text.begin(), end) + " " + units[unit];
}

double build_memory(const SceneDescription& description) {
    // As measured, with something to spare.
    constexpr double of_triangle = 96;
    constexpr double of_object = 512; // also of a point, which becomes a sphere
    double bytes = 0;
    for (const Object& object : description.objects) {
        bytes += of_object;
        const auto* mesh = std::get_if<MeshShape>(&object.shape);
        if (!mesh || !mesh->data) continue;
        const auto triangles = static_cast<double>(mesh->data->triangles.size());
        bytes += triangles > 0 ? triangles * of_triangle
                               : static_cast<double>(mesh->data->positions.size()) * of_object;
    }
    return bytes;
}

} // namespace glint
