// The templates of `glint new`.

#include "glint/formats.h"

#include "scene/text.h"

#include <array>

namespace glint {
namespace {

struct Template {
    std::string_view name;
    std::string_view text;
};

constexpr std::string_view spheres = R"(# Three balls on a floor.
#     glint spheres.toml -o spheres.png
# Lengths are in scene units, angles in degrees, z points up. All keys: docs/scene-format.md

[camera]
eye = [0, -9, 3.2]
look_at = [0, 0, 0.9]
fov = 32

[render]
size = [960, 540]
spp = 16                        # samples per pixel; 1 is fast
background = [0.35, 0.5, 0.75]  # linear RGB

# Materials have names, which the objects below refer to.

[material.floor]
color = "#b8b4a8"               # or a name, or [r, g, b] in linear light
diffuse = 0.9
reflectivity = 0.08

[material.coral]
color = "coral"
highlight = 0.4                 # a shiny spot …
shininess = 60                  # … and how small it is

[material.chrome]
color = "black"
diffuse = 0
highlight = 0.6
shininess = 200
reflectivity = 0.85             # a mirror

[material.leaf]
color = "OliveDrab3"
highlight = 0.2

# All points p with normal · p = offset.
[[plane]]
normal = [0, 0, 1]
offset = 0
material = "floor"

[[sphere]]
name = "left"                   # names are for -D sphere.left.radius=1.2
center = [-2.1, 0.3, 1]
radius = 1
material = "coral"

[[sphere]]
center = [0, 0.9, 1.3]
radius = 1.3
material = "chrome"

[[sphere]]
center = [1.9, -0.6, 0.8]
radius = 0.8
material = "leaf"

# Light from everywhere keeps the shadows from being black.
[[light]]
type = "ambient"
color = [0.12, 0.13, 0.16]

# Falls off with the square of the distance: bright numbers are normal.
[[light]]
type = "point"
position = [-4, -5, 7]
color = [1, 0.95, 0.85]
intensity = 75

[[light]]
type = "point"
position = [5, -4, 4]
color = [0.7, 0.8, 1]
intensity = 14
)";

constexpr std::string_view glass =
    R"(# A glass ball and a glass block before a striped wall: refraction, absorption, coloured shadows.
#     glint glass.toml -o glass.png

[camera]
eye = [0, -8, 2.6]
look_at = [0, 0, 1]
fov = 34

[render]
size = [960, 540]
spp = 16
background = [0.6, 0.7, 0.8]

[whitted]
max_depth = 12                  # light goes in and out of glass: give it bounces
shadows = "transmissive"        # light shines through; "opaque" is the classic look

[material.floor]
color = "#d8d2c4"
diffuse = 0.9

[material.blue]
color = "steelblue"

[material.gold]
color = "goldenrod"

[material.glass]
color = "black"                 # glass has no colour of its own
ambient = 0
diffuse = 0
highlight = 0.8
shininess = 300
transparency = 0.95             # what is seen through it
index = 1.5                     # of refraction; water is 1.33, diamond 2.42
fresnel = true                  # mirrors more at grazing angles

[material.bottle]
color = "black"
ambient = 0
diffuse = 0
highlight = 0.6
shininess = 200
transparency = 0.95
index = 1.5
absorption = [0.9, 0.15, 0.5]   # what fades per unit of the way: green is left
fresnel = true

[[plane]]
normal = [0, 0, 1]
offset = 0
material = "floor"

# A wall of bars.
[[polyhedron]]
kind = "box"
center = [-2.4, 3, 1.5]
size = [0.8, 0.4, 3]
material = "blue"

[[polyhedron]]
kind = "box"
center = [-0.8, 3, 1.5]
size = [0.8, 0.4, 3]
material = "gold"

[[polyhedron]]
kind = "box"
center = [0.8, 3, 1.5]
size = [0.8, 0.4, 3]
material = "blue"

[[polyhedron]]
kind = "box"
center = [2.4, 3, 1.5]
size = [0.8, 0.4, 3]
material = "gold"

[[sphere]]
name = "ball"
center = [-1.1, 0, 1.15]
radius = 1.1
material = "glass"

# A transform is a list, applied in order.
[[polyhedron]]
name = "block"
kind = "box"
size = [1.1, 1.1, 1.8]
material = "bottle"
transform = [
    { rotate = [0, 0, 1], angle = 30 },
    { translate = [1.4, 0.1, 0.95] },
]

[[light]]
type = "ambient"
color = [0.15, 0.15, 0.17]

[[light]]
type = "point"
position = [-3, -5, 7]
intensity = 60

[[light]]
type = "spot"
position = [4, -3, 6]
direction = [-3, 3.5, -5]       # the way the light travels
angle = 28                      # half of the cone
blend = 0.4                     # how soft its rim is
color = [1, 0.9, 0.75]
intensity = 45
)";

constexpr std::string_view mesh = R"(# A model from a PLY file, on a turntable.
# Name your own file, here or on the command line:
#     glint mesh.toml -D mesh.model.file=cat.ply -o model.png
# To look at a model just so, no scene is needed:  glint cat.ply

# Without a [camera] everything is framed.

[render]
size = [800, 800]
spp = 16
background = [0.5, 0.55, 0.6]

[material.clay]
color = "#c98a62"
highlight = 0.15
shininess = 40

[material.table]
color = [0.3, 0.32, 0.34]
reflectivity = 0.1

[[mesh]]
name = "model"
file = "model.ply"              # relative to this file
material = "clay"
scale = 1
normals = "smooth"              # "auto": those of the file, else flat
transform = [
    { rotate = [1, 0, 0], angle = 90 },   # from y up to z up
    { rotate = [0, 0, 1], angle = 25 },
]

# The same model again costs next to no memory:
#
#     [[instance]]
#     mesh = "model"
#     transform = [{ translate = [1, 0, 0] }]

[[cylinder]]
name = "turntable"
base = [0, 0, -0.1]
height = 0.1
radius = 2
material = "table"

[[light]]
type = "ambient"
color = [0.15, 0.15, 0.15]

[[light]]
type = "directional"
direction = [1, 1, -1.5]        # the way the light travels
irradiance = 0.9

[[light]]
type = "directional"
direction = [-1, 0.5, -0.4]
color = [0.6, 0.7, 1]
irradiance = 0.25
)";

constexpr std::string_view mirrors =
    R"(# A room with two mirrors and a few solids, in the manner of the classic ray-traced pictures.
#     glint mirrors.toml -o mirrors.png

[camera]
eye = [-5.5, -6.5, 3.4]
look_at = [0.4, 0.4, 1.1]
fov = 42

[render]
size = [960, 640]
spp = 16

[whitted]
max_depth = 6                   # mirrors in mirrors: how many images deep

[material.floor]
color = "LightSkyBlue3"
diffuse = 0.8
reflectivity = 0.12

[material.mirror]
color = "gray20"
diffuse = 0.3
reflectivity = 0.8

[material.orange]
color = "DarkOrange2"
highlight = 0.5
shininess = 40

[material.green]
color = "springgreen"
diffuse = 0.8
highlight = 0.3

[material.rose]
color = "PaleVioletRed"
highlight = 0.3

[[plane]]
normal = [0, 0, 1]
offset = 0
material = "floor"

# Two mirror walls, square to each other.
[[plane]]
normal = [-1, 0, 0]
offset = -3.5
material = "mirror"

[[plane]]
normal = [0, -1, 0]
offset = -3.5
material = "mirror"

[[sphere]]
center = [0.6, 0.9, 1.2]
radius = 1.2
material = "orange"

[[cylinder]]
base = [-1.6, 1.5, 0]
height = 1.7
radius = 0.6
material = "green"

[[polyhedron]]
kind = "dodecahedron"           # or box, tetrahedron, octahedron, icosahedron, prism, pyramid
center = [1.5, -1.5, 0.75]
radius = 0.9
material = "rose"

[[polyhedron]]
kind = "pyramid"
center = [-0.9, -0.9, 0]
sides = 4
radius = 0.8
height = 1.1
material = "orange"

[[light]]
type = "ambient"
color = [0.12, 0.12, 0.14]

[[light]]
type = "point"
position = [-3, -3, 5]
intensity = 28

[[light]]
type = "point"
position = [2.5, -2, 4]
color = [1, 0.85, 0.7]
intensity = 10
)";

// The first is the default template.
constexpr std::array<Template, 4> templates{{
    {"spheres", spheres},
    {"glass", glass},
    {"mirrors", mirrors},
    {"mesh", mesh},
}};

} // namespace

std::vector<std::string> template_names() {
    std::vector<std::string> names;
    for (const Template& each : templates) names.emplace_back(each.name);
    return names;
}

std::string template_text(const std::string& name) {
    for (const Template& each : templates)
        if (each.name == name) return std::string(each.text);
    std::string hint = did_you_mean(name, template_names());
    if (hint.empty()) hint = "expected one of " + listed(template_names());
    throw Error(ErrorKind::usage, "unknown template " + in_quotes(name), std::move(hint));
}

} // namespace glint
