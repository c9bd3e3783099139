#include "formats/animation_keys.h"
#include "formats/key_table.h"

#include <algorithm>

namespace glint {
namespace {

constexpr Range at_least_0{.low = 0};
constexpr Range above_0{.low = 0, .low_open = true};
constexpr Range share{.low = 0, .high = 1};
constexpr Range coordinate{.low = -coordinate_limit, .high = coordinate_limit};
constexpr Range length{.low = 0, .high = coordinate_limit, .low_open = true};

constexpr Range between(double low, double high) { return {.low = low, .high = high}; }

constexpr std::string_view standing = "prism pyramid";
constexpr std::string_view all_but_box = "tetrahedron octahedron dodecahedron icosahedron prism pyramid";

// The keys that every object has.
std::vector<KeySpec> object_keys() {
    return {
        {.key = "name",
         .type = KeyType::text,
         .help = "to be named by `-D` and by instances; unique within its table type"},
        {.key = "material",
         .type = KeyType::text,
         .required = true,
         .help = "the NAME of a `[material.NAME]`"},
        {.key = "visible",
         .type = KeyType::boolean,
         .fallback = "true",
         .help = "`false`: gone for all rays"},
        {.key = "priority",
         .type = KeyType::integer,
         .fallback = "0",
         .range = between(-2147483648.0, 2147483647.0),
         .help = "where solids overlap, the higher owns the space; among equals the later in the file"},
        {.key = "transform",
         .type = KeyType::transform,
         .fallback = "[]",
         .help = "a list of the entries below, applied in order"},
    };
}

// A table of an object: its own keys, then those of every object that it does not say otherwise.
TableSpec object_table(TableSpec table) {
    table.form = TableForm::list;
    table.object = true;
    for (const KeySpec& common : object_keys()) {
        const auto same = [&](const KeySpec& own) { return own.key == common.key; };
        if (std::none_of(table.keys.begin(), table.keys.end(), same)) table.keys.push_back(common);
    }
    return table;
}

TableSpec root_table() {
    return {
        .name = "",
        .form = TableForm::root,
        .help = "Before the first table.",
        .keys = {
            {.key = "version",
             .type = KeyType::integer,
             .fallback = "1",
             .help = "of this format; there is no other yet"},
            {.key = "color_values",
             .type = KeyType::choice,
             .fallback = "\"srgb\"",
             .choices = "srgb linear",
             .help =
                 "how colours given by name or `#` become light: decoded from sRGB, or plain numbers / 255"},
        }};
}

TableSpec camera_table() {
    return {.name = "camera",
            .help = "A pinhole camera. Without this table everything finite is framed.",
            .keys = {
                {.key = "eye",
                 .type = KeyType::point,
                 .unit = "scene units",
                 .required = true,
                 .help = "where the camera is"},
                {.key = "look_at",
                 .type = KeyType::point,
                 .unit = "scene units",
                 .required = true,
                 .alternative = "direction",
                 .help = "the point in the middle of the picture"},
                {.key = "direction",
                 .type = KeyType::direction,
                 .alternative = "look_at",
                 .help = "where the camera looks, instead of `look_at`"},
                {.key = "up",
                 .type = KeyType::direction,
                 .fallback = "[0, 0, 1]",
                 .help = "what points up in the picture; not parallel to the view"},
                {.key = "fov",
                 .fallback = "45",
                 .unit = "degrees",
                 .range = {.low = 0, .high = 180, .low_open = true, .high_open = true},
                 .help = "full angle of view"},
                {.key = "fov_axis",
                 .type = KeyType::choice,
                 .fallback = "\"y\"",
                 .choices = "y x smaller larger",
                 .help = "the side of the picture that `fov` spans"},
            }};
}

TableSpec render_table() {
    return {.name = "render",
            .help = "The picture. Flags of the command line override these.",
            .keys = {
                {.key = "size",
                 .type = KeyType::size,
                 .fallback = "[640, 480]",
                 .unit = "pixels",
                 .range = between(1, picture_side_limit),
                 .help = "width and height; at most 2^30 pixels"},
                {.key = "spp",
                 .type = KeyType::integer,
                 .fallback = "4",
                 .range = between(1, 1048576),
                 .help = "samples per pixel; 1 is the pixel's centre"},
                {.key = "seed",
                 .type = KeyType::integer,
                 .fallback = "0",
                 .range = at_least_0,
                 .help = "of the random numbers"},
                {.key = "integrator",
                 .type = KeyType::choice,
                 .fallback = "\"whitted\"",
                 .choices = "whitted",
                 .help = "the light model"},
                {.key = "filter",
                 .type = KeyType::choice,
                 .fallback = "\"mitchell\"",
                 .choices = "box tent gaussian mitchell",
                 .help = "of the pixels; radius in pixels: box 0.5, tent 1, gaussian 1.5, mitchell 2 (its "
                         "negative lobes count from 16 samples on)"},
                {.key = "background",
                 .type = KeyType::color,
                 .fallback = "[0, 0, 0]",
                 .help = "what rays see that hit nothing"},
            }};
}

TableSpec whitted_table() {
    return {.name = "whitted",
            .help = "The recursive light model.",
            .keys = {
                {.key = "max_depth",
                 .type = KeyType::integer,
                 .fallback = "8",
                 .range = between(0, 1000),
                 .help = "bounces after the first hit"},
                {.key = "shadows",
                 .type = KeyType::choice,
                 .fallback = "\"transmissive\"",
                 .choices = "transmissive opaque",
                 .help = "whether light shines through transparent objects"},
                {.key = "clamp",
                 .type = KeyType::boolean,
                 .fallback = "false",
                 .help = "limit each light's diffuse term, and then the local sum, to 1"},
                {.key = "energy",
                 .type = KeyType::choice,
                 .fallback = "\"report\"",
                 .choices = "report balanced",
                 .help = "`\"balanced\"` scales the local light by 1 − ρ − τ and needs ρ + τ ≤ 1"},
                {.key = "highlight_model",
                 .type = KeyType::choice,
                 .fallback = "\"blinn\"",
                 .choices = "blinn phong",
                 .help = "by the half-way vector, or by the mirror direction"},
                {.key = "index",
                 .fallback = "1.0",
                 .range = above_0,
                 .help = "of refraction, of what surrounds everything"},
            }};
}

TableSpec material_table() {
    return {
        .name = "material",
        .form = TableForm::named,
        .help = "What surfaces look like. Objects name it.",
        .keys = {
            {.key = "color", .type = KeyType::color, .fallback = "[0.8, 0.8, 0.8]", .help = "c"},
            {.key = "ambient",
             .fallback = "1.0",
             .range = at_least_0,
             .help = "k_a, share of the ambient light"},
            {.key = "diffuse",
             .fallback = "1.0",
             .range = at_least_0,
             .help = "k_d, share of the light that arrives"},
            {.key = "highlight",
             .fallback = "0.0",
             .range = at_least_0,
             .help = "k, strength of the highlight"},
            {.key = "shininess",
             .fallback = "32",
             .range = at_least_0,
             .help = "m, the highlight's exponent"},
            {.key = "reflectivity",
             .fallback = "0.0",
             .range = at_least_0,
             .help = "ρ, weight of the mirror image; above 1 gives more light than it gets, and warns"},
            {.key = "transparency",
             .fallback = "0.0",
             .range = share,
             .help = "τ, weight of what is seen through it"},
            {.key = "index",
             .fallback = "1.5",
             .range = above_0,
             .help = "η of refraction, used where τ > 0"},
            {.key = "absorption",
             .type = KeyType::rgb,
             .fallback = "[0, 0, 0]",
             .unit = "per scene unit",
             .help = "σ, inside solids: light fades as e^(−σ · distance)"},
            {.key = "fresnel",
             .type = KeyType::boolean,
             .fallback = "false",
             .help = "share ρ + τ between mirror and refraction by Fresnel's equations"},
            {.key = "emission", .type = KeyType::color, .fallback = "[0, 0, 0]", .help = "light of its own"},
        }};
}

TableSpec plane_table() {
    return object_table(
        {.name = "plane",
         .help = "All p with normal · p = offset, taken literally: the normal need not be of unit length.",
         .keys = {
             {.key = "normal", .type = KeyType::direction, .required = true, .help = "square to the plane"},
             {.key = "offset",
              .fallback = "0",
              .unit = "scene units × length of the normal",
              .help = "normal · p"},
             {.key = "solid",
              .type = KeyType::boolean,
              .fallback = "false",
              .help = "`true`: the half-space behind the normal, not a thin sheet"},
         }});
}

TableSpec sphere_table() {
    return object_table(
        {.name = "sphere",
         .help = "A solid ball.",
         .keys = {
             {.key = "center", .type = KeyType::point, .unit = "scene units", .required = true},
             {.key = "radius", .unit = "scene units", .range = length, .required = true},
         }});
}

TableSpec cylinder_table() {
    return object_table({.name = "cylinder",
                         .help = "A solid cylinder with both caps.",
                         .keys = {
                             {.key = "base",
                              .type = KeyType::point,
                              .unit = "scene units",
                              .required = true,
                              .help = "centre of the bottom disc"},
                             {.key = "axis",
                              .type = KeyType::direction,
                              .fallback = "[0, 0, 1]",
                              .help = "from bottom to top"},
                             {.key = "height", .unit = "scene units", .range = length, .required = true},
                             {.key = "radius", .unit = "scene units", .range = length, .required = true},
                         }});
}

TableSpec triangle_table() {
    return object_table({.name = "triangle",
                         .help = "One triangle, seen from both sides.",
                         .keys = {
                             {.key = "vertices",
                              .type = KeyType::vertices,
                              .unit = "scene units",
                              .required = true,
                              .help = "three points, not on one line"},
                         }});
}

TableSpec polyhedron_table() {
    return object_table(
        {.name = "polyhedron",
         .selector = "kind",
         .help =
             "A solid with flat faces. Tetrahedron, octahedron and icosahedron stand with a vertex on +z, "
             "the "
             "dodecahedron with a face centre on +z; the first corner off the z axis, counted from the top, "
             "lies "
             "toward +x. The first corner of a prism or pyramid lies toward +x, turned with the axis by the "
             "shortest rotation from +z.",
         .keys = {
             {.key = "kind",
              .type = KeyType::choice,
              .required = true,
              .choices = "box tetrahedron octahedron dodecahedron icosahedron prism pyramid"},
             {.key = "center",
              .type = KeyType::point,
              .fallback = "[0, 0, 0]",
              .unit = "scene units",
              .help = "of the box; of the circumscribed sphere of Platonic solids; of the bottom face of "
                      "prism and pyramid"},
             {.key = "size",
              .type = KeyType::lengths,
              .fallback = "[1, 1, 1]",
              .unit = "scene units",
              .range = length,
              .types = "box",
              .help = "edge lengths"},
             {.key = "radius",
              .fallback = "1",
              .unit = "scene units",
              .range = length,
              .types = all_but_box,
              .help = "circumscribed; of the bottom face for prism and pyramid"},
             {.key = "sides",
              .type = KeyType::integer,
              .fallback = "6",
              .range = between(3, 65536),
              .types = standing,
              .help = "corners of the bottom face"},
             {.key = "height", .fallback = "1", .unit = "scene units", .range = length, .types = standing},
             {.key = "axis",
              .type = KeyType::direction,
              .fallback = "[0, 0, 1]",
              .types = standing,
              .help = "from the bottom face up"},
         }});
}

TableSpec mesh_table() {
    return object_table(
        {.name = "mesh",
         .help = "Triangles from a PLY file.",
         .keys = {
             {.key = "file",
              .type = KeyType::file,
              .required = true,
              .help = "relative to the scene file and within its folder, unless `--allow-outside`"},
             {.key = "scale",
              .type = KeyType::scale,
              .fallback = "1",
              .help = "before `transform`; negative mirrors"},
             {.key = "normals",
              .type = KeyType::choice,
              .fallback = "\"auto\"",
              .choices = "auto flat smooth",
              .help = "`\"auto\"`: stored ones if any, else flat; `\"smooth\"`: weighted by angle"},
             {.key = "facing",
              .type = KeyType::choice,
              .fallback = "\"viewer\"",
              .choices = "viewer stored",
              .help = "where lights find its normals: turned to the viewer, or as its winding has them, so "
                      "that the "
                      "inside of an open mesh is lit through its back, as in the report's pictures"},
             {.key = "vertex_colors",
              .type = KeyType::choice,
              .fallback = "\"auto\"",
              .choices = "auto ignore",
              .help = "`\"auto\"`: they replace the material's `color` where stored (bytes are sRGB)"},
             {.key = "point_radius",
              .type = KeyType::number_or_auto,
              .fallback = "\"auto\"",
              .unit = "scene units",
              .range = length,
              .help = "files without faces: spheres of this radius"},
         }});
}

TableSpec instance_table() {
    return object_table(
        {.name = "instance",
         .help = "A mesh again: its own scale and transform first, then this one's.",
         .keys = {
             {.key = "mesh", .type = KeyType::text, .required = true, .help = "the `name` of a `[[mesh]]`"},
             {.key = "material", .type = KeyType::text, .help = "without it, the mesh's"},
         }});
}

TableSpec light_table() {
    return {.name = "light",
            .form = TableForm::list,
            .selector = "type",
            .help = "Lights add up in their order.",
            .keys = {
                {.key = "type",
                 .type = KeyType::choice,
                 .required = true,
                 .choices = "ambient point directional spot"},
                {.key = "position",
                 .type = KeyType::point,
                 .unit = "scene units",
                 .required = true,
                 .types = "point spot"},
                {.key = "direction",
                 .type = KeyType::direction,
                 .required = true,
                 .types = "directional spot",
                 .help = "the way the light travels"},
                {.key = "angle",
                 .fallback = "30",
                 .unit = "degrees",
                 .range = {.low = 0, .high = 90, .low_open = true},
                 .types = "spot",
                 .help = "half angle of the cone"},
                {.key = "blend",
                 .fallback = "0.1",
                 .range = share,
                 .types = "spot",
                 .help = "soft share of the cone: full light within angle · (1 − blend)"},
                {.key = "color",
                 .type = KeyType::color,
                 .fallback = "[0.1, 0.1, 0.1]",
                 .types = "ambient",
                 .help = "the ambient light itself"},
                {.key = "color",
                 .type = KeyType::color,
                 .fallback = "[1, 1, 1]",
                 .types = "point directional spot"},
                {.key = "intensity",
                 .fallback = "1",
                 .range = at_least_0,
                 .alternative = "radiant_intensity",
                 .types = "point spot",
                 .help = "a white matte surface facing it at distance 1 shows 1.0"},
                {.key = "radiant_intensity",
                 .unit = "W/sr",
                 .range = at_least_0,
                 .alternative = "intensity",
                 .types = "point spot",
                 .help = "`intensity` · π, instead of it"},
                {.key = "irradiance",
                 .fallback = "1",
                 .range = at_least_0,
                 .types = "directional",
                 .help = "a white matte surface facing it shows 1.0"},
            }};
}

TableSpec transform_table() {
    return {.name = "transform",
            .form = TableForm::entry,
            .help = "Each entry holds one of these. Rotations and scalings are about the world's origin.",
            .keys = {
                {.key = "translate", .type = KeyType::point, .unit = "scene units"},
                {.key = "rotate", .type = KeyType::direction, .help = "the axis; goes with `angle`"},
                {.key = "angle",
                 .unit = "degrees",
                 .range = coordinate,
                 .help = "goes with `rotate`; counter-clockwise looking against the axis"},
                {.key = "scale", .type = KeyType::scale, .help = "negative mirrors"},
                {.key = "matrix",
                 .type = KeyType::matrix,
                 .help = "affine and regular: the last row is 0, 0, 0, 1"},
            }};
}

} // namespace

const std::vector<TableSpec>& table_specs() {
    static const std::vector<TableSpec> tables = {
        root_table(),     camera_table(),     render_table(),    whitted_table(),
        material_table(), plane_table(),      sphere_table(),    cylinder_table(),
        triangle_table(), polyhedron_table(), mesh_table(),      instance_table(),
        light_table(),    transform_table(),  animation_table(), animate_table(),
    };
    return tables;
}

} // namespace glint
