// Finding vertices, faces and strips by the usual names of elements and properties.

#include "formats/ply/layout.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace glint::formats::ply {
namespace {

/// The names of each role, in the order of Role.
constexpr std::string_view spellings[role_count][4] = {{"x"},
                                                       {"y"},
                                                       {"z"},
                                                       {"nx", "normal_x"},
                                                       {"ny", "normal_y"},
                                                       {"nz", "normal_z"},
                                                       {"red", "r", "diffuse_red"},
                                                       {"green", "g", "diffuse_green"},
                                                       {"blue", "b", "diffuse_blue"},
                                                       {"u", "s", "texture_u", "texture_s"},
                                                       {"v", "t", "texture_v", "texture_t"}};

constexpr std::size_t index_of(Role role) { return static_cast<std::size_t>(role); }

Role role_named(std::string_view name) {
    std::size_t role = 0;
    while (role < role_count && std::ranges::find(spellings[role], name) == std::end(spellings[role])) ++role;
    return static_cast<Role>(role);
}

/// "colour ", "texture coordinate " or nothing, before the name of a property.
std::string kind_of(const Property& property) {
    const Role role = role_named(property.name);
    if (role == Role::u || role == Role::v || property.name.starts_with("tex")) return "texture coordinate ";
    if (role == Role::red || role == Role::green || role == Role::blue) return "colour ";
    return {};
}

/// Does a vertex property take part in the picture?
bool is_drawn(const VertexFormat& vertex, std::size_t property) {
    switch (vertex.roles[property]) {
    case Role::x:
    case Role::y:
    case Role::z:
        return true;
    case Role::nx:
    case Role::ny:
    case Role::nz:
        return vertex.normals;
    case Role::red:
    case Role::green:
    case Role::blue:
        return vertex.colors;
    default:
        return false;
    }
}

std::string names_of_properties(const Element& element) {
    constexpr std::size_t max_shown = 12;
    std::string names;
    for (std::size_t i = 0; i < element.properties.size() && i < max_shown; ++i)
        names += (i ? ", " : "") + quoted_word(element.properties[i].name);
    if (element.properties.size() > max_shown) names += " …";
    return names.empty() ? "none" : names;
}

VertexFormat interpret_vertex(const Source& source, const Element& element) {
    VertexFormat format;
    format.roles.assign(element.properties.size(), Role::none);
    std::array<bool, role_count> found{};

    // If a role appears under two names, the first counts.
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const Property& property = element.properties[i];
        const Role role = property.is_list() ? Role::none : role_named(property.name);
        if (role == Role::none || found[index_of(role)]) continue;
        found[index_of(role)] = true;
        format.types[index_of(role)] = property.type;
        format.roles[i] = role;
    }

    for (const Role role : {Role::x, Role::y, Role::z})
        if (!found[index_of(role)])
            source.fail_in_text(
                element.name_offset, std::string("a vertex has no number '") + "xyz"[index_of(role)] + "'",
                "vertices need the properties x, y and z; these have: " + names_of_properties(element));

    const auto all = [&](std::initializer_list<Role> roles) {
        for (const Role role : roles)
            if (!found[index_of(role)]) return false;
        return true;
    };
    format.normals = all({Role::nx, Role::ny, Role::nz});
    format.colors = all({Role::red, Role::green, Role::blue});
    format.uvs = all({Role::u, Role::v});
    return format;
}

/// Index of the property with the vertex indices; −1 if there is none.
int find_corners(const Source& source, const Element& element) {
    int found = -1;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const Property& property = element.properties[i];
        if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
        if (found >= 0)
            source.fail_in_text(property.offset,
                                "element " + quoted_word(element.name) + " lists its corners twice",
                                "keep one of vertex_indices and vertex_index");
        if (!property.is_list())
            source.fail_in_text(property.offset, quoted_word(property.name) + " is not a list",
                                "expected: property list uchar int vertex_indices");
        if (!is_integer(property.type))
            source.fail_in_text(property.type_offset,
                                std::string("vertex indices cannot be of type '") + type_name(property.type) +
                                    "'",
                                "expected an integer type, such as int");
        found = static_cast<int>(i);
    }
    if (found < 0 && element.count > 0)
        source.fail_in_text(
            element.name_offset, "element " + quoted_word(element.name) + " has no list of corners",
            "expected: property list uchar int vertex_indices; it has: " + names_of_properties(element));
    return found;
}

std::size_t find_vertices(const Source& source, const Header& header) {
    const Element* found = nullptr;
    for (const Element& element : header.elements) {
        if (element.name != "vertex") continue;
        if (found)
            source.fail_in_text(element.name_offset, "the header has a second element 'vertex'",
                                "remove one of them");
        found = &element;
    }
    if (!found) {
        for (const Element& element : header.elements)
            if (nearest_name(element.name, {"vertex", "vertices", "point", "points"}))
                source.fail_in_text(element.name_offset, "the file has no element 'vertex'",
                                    "did you mean 'vertex' by " + quoted_word(element.name) + "?");
        source.fail_in_text(header.end_header, "the file has no element 'vertex'", "a mesh needs vertices");
    }
    if (found->count == 0)
        source.fail_in_text(found->count_offset, "the file has no vertices", "there is nothing to draw");
    if (found->count > std::numeric_limits<std::uint32_t>::max())
        source.fail_in_text(found->count_offset, "the header promises more than 4294967295 vertices",
                            "the header is wrong, or the mesh must be split");
    return static_cast<std::size_t>(found - header.elements.data());
}

} // namespace

std::vector<std::string> not_drawn(const Header& header, const MeshLayout& layout) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < header.elements.size(); ++i) {
        const Element& element = header.elements[i];
        if (element.count == 0) continue;
        const bool is_vertex = i == layout.vertex_element;
        if (!is_vertex && layout.corners[i] < 0) {
            // The warning that there are no faces names these.
            if (!layout.has_faces && may_mean_faces(element)) continue;
            names.push_back("element " + quoted_word(element.name));
            continue;
        }
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const Property& property = element.properties[p];
            // What programs write beside every colour, usually opaque.
            if (property.name == "alpha") continue;
            if (is_vertex ? is_drawn(layout.vertex, p) : static_cast<int>(p) == layout.corners[i]) continue;
            names.push_back(kind_of(property) + quoted_word(property.name) + " of " + element.name);
        }
    }
    return names;
}

bool may_mean_faces(const Element& element) {
    return nearest_name(element.name, {"face", "faces", "triangle", "triangles"}).has_value();
}

bool is_strips(const Element& element) { return element.name == "tristrips"; }

MeshLayout interpret_header(const Source& source, const Header& header) {
    MeshLayout layout;
    layout.vertex_element = find_vertices(source, header);
    layout.vertex = interpret_vertex(source, header.elements[layout.vertex_element]);
    for (const Element& element : header.elements) {
        const bool has_corners = element.name == "face" || is_strips(element);
        layout.corners.push_back(has_corners ? find_corners(source, element) : -1);
        if (has_corners && element.count > 0) layout.has_faces = true;
    }
    return layout;
}

} // namespace glint::formats::ply
