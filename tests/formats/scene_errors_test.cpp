// What is wrong with a scene file is said with its place, its cause and its cure.

#include "scene_support.h"

#include <algorithm>

namespace glint::test {
namespace {

struct Malformed {
    const char* claim;
    const char* text;
    int line;
    int column;
    const char* message; ///< a part of the first error's message
    const char* hint;    ///< a part of its hint
};

const Malformed malformed[] = {
    // TOML itself
    {"unclosed string", "[camera]\neye = \"abc\n", 2, 11, "syntax error in string", ""},
    {"missing value", "version = \n", 1, 11, "syntax error in key-value pair", ""},
    {"key given twice", "[render]\nspp = 1\nspp = 2\n", 3, 7, "cannot redefine existing integer 'spp'", ""},
    {"table given twice", "[render]\n[camera]\n[render]\n", 3, 1, "cannot redefine existing table 'render'",
     ""},
    {"integer too large", "render.seed = 99999999999999999999\n", 1, 15,
     "the number 99999999999999999999 is out of range", "integers go up to"},
    {"number too large", "[camera]\nfov = -1e400 # far\n", 2, 7, "the number -1e400 is out of range",
     "1.8e308"},
    {"number too large in a list", "[camera]\neye = [0, 0, 1e999]\n", 2, 14,
     "the number 1e999 is out of range", ""},
    {"a name without quotes", "[[sphere]]\nmaterial = glass\n", 2, 12, "\"glass\" stands without quotes",
     "stand in quotes: \"glass\""},
    {"a name without quotes that begins like a boolean", "[[sphere]]\nmaterial = tiles\n", 2, 12,
     "\"tiles\" stands without quotes", ""},
    {"names without quotes in a list", "a = [\"x\", red]\n", 1, 11, "\"red\" stands without quotes", ""},
    {"a boolean in capitals", "[[sphere]]\nvisible = True\n", 2, 11, "\"True\" is no boolean",
     "true or false"},
    {"yes", "[[sphere]]\nvisible = yes\n", 2, 11, "\"yes\" is no boolean", "true or false"},
    {"a number that begins with a point", "[[sphere]]\nradius = -.5\n", 2, 10, "\"-.5\" begins with a point",
     "write -0.5"},
    {"a number that ends with a point", "[[sphere]]\nradius = 5.\n", 2, 10, "\"5.\" ends with a point",
     "write 5.0"},
    {"a list in round brackets", "[camera]\neye = (0, 0, 0)\n", 2, 7, "a list without brackets", "[1, 2, 3]"},
    {"a list without brackets", "[camera]\neye = 0, 0, 0\n", 2, 7, "a list without brackets", "[1, 2, 3]"},
    {"other syntax errors stay as they are", "[camera]\neye 5\n", 2, 5, "syntax error in key-value pair", ""},
    {"invalid UTF-8", "# fine\nversion = \"\xff\"\n", 2, 11, "invalid utf-8", ""},
    {"zero byte", nullptr, 2, 3, "a zero byte", "expected a scene file"},
    {"UTF-16", "\xff\xfe[", 1, 1, "UTF-16", "UTF-8"},
    {"letters beyond ASCII in a key", "\n gr\u00f6\u00dfe = 1\n", 2, 4, "a character beyond ASCII outside",
     "between quotes"},
    {"curly quotes", "version = \u201c1\u201d\n", 1, 11, "a character beyond ASCII outside",
     "between quotes"},
    {"lists nested without end", "a = [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[", 1, 0,
     "exceeded maximum nested", ""},
    {"dotted key without end", "\na.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = 1", 2, 32,
     "a dotted key of more than 16 parts", ""},

    // Tables and keys
    {"unknown table", "[camra]\n", 1, 2, "unknown table \"camra\"", "did you mean \"camera\"?"},
    {"unknown list of tables", "\n[[spheres]]\nradius = 1", 2, 3, "unknown table \"spheres\"",
     "did you mean \"sphere\"?"},
    {"unknown key at the top", "versoin = 1\n", 1, 1, "unknown key \"versoin\"", "did you mean \"version\"?"},
    {"color_values in a table", "[render]\ncolor_values = \"linear\"\n", 2, 1,
     "unknown key \"color_values\" in [render]", "size"},
    {"unknown key", "[render]\n  sppp = 1\n", 2, 3, "unknown key \"sppp\" in [render]",
     "did you mean \"spp\"?"},
    {"unknown key of a material", "[material.red]\ncolour = \"red\"\n", 2, 1,
     "unknown key \"colour\" in [material.red]", "did you mean \"color\"?"},
    {"a table where a list belongs", "[sphere]\nradius = 1\n", 1, 2,
     "\"sphere\" is written as [[sphere]], found a table", ""},
    {"a list where a table belongs", "[[camera]]\n", 1, 3, "\"camera\" is written as [camera], found a list",
     ""},
    {"a value where a table belongs", "render = 3\n", 1, 1,
     "\"render\" is written as [render], found an integer", ""},
    {"material without a name", "[material]\ncolor = [1, 0, 0]\n", 2, 1,
     "expected a table [material.NAME], found a list named \"color\"", ""},
    {"material with an empty name", "[material.\"\"]\n", 1, 11,
     "the name of a \"material\" must not be empty", ""},
    {"a number among tables", "sphere = [3]\n", 1, 11, "expected a table in \"sphere\", found an integer",
     "[[sphere]]"},
    {"transform at the top", "[transform]\n", 1, 2, "unknown table \"transform\"", ""},
    {"another version", "version = 2\n", 1, 11, "this scene file is of version 2", "reads version 1"},
    {"version with a fraction", "version = 1.0\n", 1, 11,
     "expected an integer for \"version\", found a number", ""},

    // Missing keys name the header
    {"missing radius", "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nmaterial = \"m\"\n", 2, 1,
     "missing required key \"radius\" in [[sphere]]", ""},
    {"missing material", "\n\n  [[sphere]]\ncenter = [0,0,0]\nradius = 1\n", 3, 3,
     "missing required key \"material\" in [[sphere]]", "[material.NAME]"},
    {"missing eye", "[camera]\nlook_at = [0,0,0]\n", 1, 1, "missing required key \"eye\" in [camera]", ""},
    {"missing look_at", "[camera]\neye = [0,0,0]\n", 1, 1,
     "missing required key \"look_at\" (or \"direction\") in [camera]", ""},
    {"missing kind", "[material.m]\n[[polyhedron]]\nmaterial = \"m\"\n", 2, 1,
     "missing required key \"kind\" in [[polyhedron]]", ""},
    {"missing type", "[[light]]\nintensity = 3\n", 1, 1, "missing required key \"type\" in [[light]]", ""},
    {"missing position", "[[light]]\ntype = \"point\"\n", 1, 1,
     "missing required key \"position\" in [[light]]", ""},
    {"missing direction", "[[light]]\ntype = \"spot\"\nposition = [0,0,0]\n", 1, 1,
     "missing required key \"direction\" in [[light]]", "the way the light travels"},
    {"missing mesh of an instance", "[[instance]]\n", 1, 1, "missing required key \"mesh\" in [[instance]]",
     ""},

    // Keys of another type
    {"radius of a box", "[material.m]\n[[polyhedron]]\nkind = \"box\"\nradius = 1\nmaterial = \"m\"\n", 4, 1,
     "key \"radius\" does not belong to [[polyhedron]] with kind = \"box\"", "size"},
    {"size of a prism", "[material.m]\n[[polyhedron]]\nkind = \"prism\"\nsize = [1,1,1]\nmaterial = \"m\"\n",
     4, 1, "key \"size\" does not belong", "sides"},
    {"sides of an icosahedron",
     "[material.m]\n[[polyhedron]]\nkind = \"icosahedron\"\nsides = 5\nmaterial = \"m\"\n", 4, 1,
     "key \"sides\" does not belong", "radius"},
    {"blend of a point light", "[[light]]\ntype = \"point\"\nposition = [0,0,0]\nblend = 0.5\n", 4, 1,
     "key \"blend\" does not belong to [[light]] with type = \"point\"", "intensity"},
    {"intensity of ambient light", "[[light]]\ntype = \"ambient\"\nintensity = 1\n", 3, 1,
     "key \"intensity\" does not belong", "color"},
    {"roughness of a material without a model", "[material.m]\nroughness = 0.5\n", 2, 1,
     "key \"roughness\" does not belong to [material.m] with model = \"whitted\"", "reflectivity"},
    {"reflectivity of a conductor", "[material.m]\nmodel = \"conductor\"\nreflectivity = 1\n", 3, 1,
     "key \"reflectivity\" does not belong to [material.m] with model = \"conductor\"", "metal"},
    {"index of a diffuse material", "[material.m]\nindex = 1.5\nmodel = \"diffuse\"\n", 2, 1,
     "key \"index\" does not belong", "color"},

    // Keys that exclude each other
    {"look_at and direction", "[camera]\neye = [0,0,0]\nlook_at = [0,1,0]\ndirection = [0,1,0]\n", 4, 13,
     "\"direction\" cannot go together with \"look_at\"", "keep one"},
    {"intensity twice",
     "[[light]]\ntype = \"point\"\nposition = [0,0,0]\nradiant_intensity = 1\nintensity = 1\n", 5, 13,
     "\"intensity\" cannot go together with \"radiant_intensity\"", "keep one"},
    {"metal with a color", "[material.m]\nmodel = \"conductor\"\nmetal = \"gold\"\ncolor = \"red\"\n", 4, 9,
     "\"color\" cannot go together with \"metal\"", "keep one"},

    // Materials
    {"unknown model", "[material.m]\nmodel = \"plastik\"\n", 2, 9, "unknown model \"plastik\"",
     "did you mean \"plastic\"?"},
    {"unknown metal", "[material.m]\nmodel = \"conductor\"\nmetal = \"glod\"\n", 3, 9,
     "unknown metal \"glod\"", "did you mean \"gold\"?"},
    {"roughness above 1", "[material.m]\nmodel = \"plastic\"\nroughness = 2\n", 3, 13,
     "\"roughness\" must be between 0 and 1", ""},
    {"opacity below 0", "[material.m]\nopacity = -1\n", 2, 11, "\"opacity\" must be between 0 and 1", ""},

    // Types
    {"text for a number", "[whitted]\nindex = \"1.3\"\n", 2, 9,
     "expected a number for \"index\", found a string", ""},
    {"fraction for an integer", "[whitted]\nmax_depth = 4.0\n", 2, 13,
     "expected an integer for \"max_depth\", found a number", ""},
    {"integer for a boolean", "[whitted]\nclamp = 1\n", 2, 9,
     "expected a boolean (true or false) for \"clamp\", found an integer", ""},
    {"date for a number", "[whitted]\nindex = 2020-01-01\n", 2, 9,
     "expected a number for \"index\", found a date or time", ""},
    {"two numbers for a point", "[camera]\neye = [1, 2]\nlook_at = [0,0,0]\n", 2, 7,
     "expected a list of 3 numbers for \"eye\", found 2", ""},
    {"text in a point", "[camera]\neye = [1, \"2\", 3]\nlook_at = [0,0,0]\n", 2, 11,
     "expected a number for \"eye\", found a string", ""},
    {"number for a point", "[camera]\neye = 1\nlook_at = [0,0,0]\n", 2, 7,
     "expected a list of 3 numbers for \"eye\", found an integer", ""},
    {"number for text", "[render]\nfilter = 3\n", 2, 10, "expected a string for \"filter\", found an integer",
     ""},
    {"number for a colour", "[render]\nbackground = 3\n", 2, 14, "expected a colour", ""},
    {"one side for a size", "[render]\nsize = [640]\n", 2, 8,
     "expected [width, height] for \"size\", found 1 number", ""},
    {"fraction in a size", "[render]\nsize = [640, 480.0]\n", 2, 14,
     "expected an integer for \"size\", found a number", ""},
    {"text for a point_radius",
     "[material.m]\n[[mesh]]\nfile = \"a.ply\"\nmaterial = \"m\"\npoint_radius = \"big\"\n", 5, 16,
     "expected a number or \"auto\" for \"point_radius\"", ""},
    {"table for a transform",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = { translate = "
     "[1,0,0] }\n",
     6, 13, "expected a list for \"transform\", found a table", ""},

    // Ranges
    {"radius 0", "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 0\nmaterial = \"m\"\n", 4, 10,
     "\"radius\" must be above 0 and at most 1e+12, found 0", ""},
    {"transparency above 1", "[material.m]\ntransparency = 1.5\n", 2, 16,
     "\"transparency\" must be between 0 and 1, found 1.5", ""},
    {"negative diffuse", "[material.m]\ndiffuse = -1\n", 2, 11, "\"diffuse\" must be at least 0, found -1",
     ""},
    {"negative colour", "[material.m]\ncolor = [0, -0.5, 0]\n", 2, 13,
     "\"color\" must be at least 0, found -0.5", ""},
    {"negative absorption", "[material.m]\nabsorption = [0, -0.5, 0]\n", 2, 18,
     "\"absorption\" must be at least 0", ""},
    {"index 0", "[material.m]\nindex = 0\n", 2, 9, "\"index\" must be above 0, found 0", ""},
    {"fov 180", "[camera]\neye = [0,0,1]\nlook_at = [0,1,0]\nfov = 180\n", 4, 7,
     "\"fov\" must be above 0 and below 180, found 180", ""},
    {"angle above 90", "[[light]]\ntype = \"spot\"\nposition = [0,0,0]\ndirection = [0,0,1]\nangle = 91\n", 5,
     9, "\"angle\" must be above 0 and at most 90, found 91", ""},
    {"sides 2", "[material.m]\n[[polyhedron]]\nkind = \"prism\"\nsides = 2\nmaterial = \"m\"\n", 4, 9,
     "\"sides\" must be between 3 and 65536, found 2", ""},
    {"spp 0", "[render]\nspp = 0\n", 2, 7, "\"spp\" must be between 1 and 1048576, found 0", ""},
    {"depth 1001", "[whitted]\nmax_depth = 1001\n", 2, 13,
     "\"max_depth\" must be between 0 and 1000, found 1001", ""},
    {"negative seed", "[render]\nseed = -1\n", 2, 8, "\"seed\" must be at least 0, found -1", ""},
    {"side too long", "[render]\nsize = [65537, 1]\n", 2, 9,
     "\"size\" must be between 1 and 65536, found 65537", ""},
    {"too many pixels", "[render]\nsize = [65536, 16385]\n", 2, 8, "\"size\" is above 2^30 pixels", ""},
    {"NaN", "[camera]\neye = [0, nan, 0]\nlook_at = [0,1,0]\n", 2, 11, "\"eye\" must be finite, found nan",
     ""},
    {"infinity", "[whitted]\nindex = inf\n", 2, 9, "\"index\" must be finite, found inf", ""},
    {"far coordinate", "[camera]\neye = [0, 0, -1.5e12]\nlook_at = [0,1,0]\n", 2, 14,
     "\"eye\" must be between -1e+12 and 1e+12, found -1.5e+12", ""},
    {"scale 0", "[material.m]\n[[mesh]]\nfile = \"a.ply\"\nscale = [1, 0, 1]\nmaterial = \"m\"\n", 4, 9,
     "\"scale\" must not be 0", "negative"},
    {"unknown choice", "[render]\nfilter = \"boxx\"\n", 2, 10, "unknown filter \"boxx\"",
     "did you mean \"box\"? Expected one of box, tent, gaussian, mitchell"},
    {"empty name", "[material.m]\n[[sphere]]\nname = \"\"\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\n",
     3, 8, "\"name\" must not be empty", ""},

    // Geometry
    {"zero normal", "[material.m]\n[[plane]]\nnormal = [0, 0, 0]\nmaterial = \"m\"\n", 3, 10,
     "\"normal\" must not be zero", "direction"},
    {"zero axis",
     "[material.m]\n[[cylinder]]\nbase = [0,0,0]\nheight = 1\nradius = 1\naxis = [0, -0.0, 0]\nmaterial = "
     "\"m\"\n",
     6, 8, "\"axis\" must not be zero", ""},
    {"zero direction", "[[light]]\ntype = \"directional\"\ndirection = [0, 0, 0]\n", 3, 13,
     "\"direction\" must not be zero", ""},
    {"a direction too small to have one", "[[light]]\ntype = \"directional\"\ndirection = [0, 0, 1e-200]\n",
     3, 13, "\"direction\" has a length beyond all measure", ""},
    {"zero up", "[camera]\neye = [0,0,0]\nlook_at = [0,1,0]\nup = [0,0,0]\n", 4, 6, "\"up\" must not be zero",
     ""},
    {"up along the view", "[camera]\neye = [0,0,0]\nlook_at = [1,2,3]\nup = [-2,-4,-6]\n", 4, 6,
     "\"up\" is parallel to the view", "choose an up"},
    {"default up along the view", "[camera]\neye = [0,0,5]\nlook_at = [0,0,0]\n", 3, 11,
     "\"up\" is parallel to the view", "choose an up"},
    {"looking at the eye", "[camera]\neye = [1,2,3]\nlook_at = [1,2,3]\n", 3, 11,
     "\"look_at\" is where the \"eye\" is", ""},
    {"degenerate triangle",
     "[material.m]\n[[triangle]]\nvertices = [[0.1,0.2,0.3], [0.2,0.4,0.6], [0.3,0.6,0.9]]\nmaterial = "
     "\"m\"\n",
     3, 12, "the triangle is degenerate", ""},
    {"rectangle with parallel edges",
     "[material.m]\n[[rectangle]]\ncorner = [0,0,0]\nu = [0.1,0.2,0.3]\nv = [-0.2,-0.4,-0.6]\nmaterial = "
     "\"m\"\n",
     2, 1, "the rectangle has no area: its edges are parallel", ""},
    {"rectangle without an edge",
     "[material.m]\n[[rectangle]]\ncorner = [0,0,0]\nu = [1,0,0]\nmaterial = \"m\"\n", 2, 1,
     "missing required key \"v\" in [[rectangle]]", ""},
    {"disk without a direction",
     "[material.m]\n[[disk]]\ncenter = [0,0,0]\nnormal = [0,0,0]\nradius = 1\nmaterial = \"m\"\n", 4, 10,
     "\"normal\" must not be zero", ""},
    {"flat cone", "[material.m]\n[[cone]]\nbase = [0,0,0]\nheight = 0\nradius = 1\nmaterial = \"m\"\n", 4, 10,
     "\"height\" must be above 0", ""},
    {"two vertices of a triangle",
     "[material.m]\n[[triangle]]\nvertices = [[0,0,0], [1,0,0]]\nmaterial = \"m\"\n", 3, 12,
     "expected a list of 3 points for \"vertices\", found 2", ""},
    {"sphere reaching too far",
     "[material.m]\n[[sphere]]\ncenter = [9e11,0,0]\nradius = 2e11\nmaterial = \"m\"\n", 2, 1,
     "the object reaches beyond 10^12", ""},
    {"plane too far", "[material.m]\n[[plane]]\nnormal = [0,0,1e-3]\noffset = 1e10\nmaterial = \"m\"\n", 2, 1,
     "the object reaches beyond 10^12", ""},
    {"moved too far",
     "[material.m]\n[[sphere]]\ncenter = [9e11,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ translate "
     "= [9e11,0,0] }]\n",
     6, 13, "the object is moved beyond 10^12", ""},

    // Transforms
    {"empty entry",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{}]\n", 6, 14,
     "an empty entry of \"transform\"", "expected translate"},
    {"two in one entry",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ translate = "
     "[1,0,0], scale = 2 }]\n",
     6, 14, "holds one of translate", "one entry each"},
    {"rotation without angle",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ rotate = "
     "[1,0,0] }]\n",
     6, 25, "\"rotate\" needs \"angle\"", "angle"},
    {"angle without rotation",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ angle = 3 "
     "}]\n",
     6, 24, "\"angle\" needs \"rotate\"", "rotate"},
    {"unknown transformation",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ translat = "
     "[1,0,0] }]\n",
     6, 16, "unknown key \"translat\"", "did you mean \"translate\"?"},
    {"number among transformations",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [3]\n", 6, 14,
     "expected a table in \"transform\", found an integer", "translate"},
    {"scale 0 in a transform",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ scale = 0 "
     "}]\n",
     6, 24, "\"scale\" must not be 0", ""},
    {"matrix of 15 numbers",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ matrix = "
     "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0] }]\n",
     6, 25, "expected a list of 16 numbers for \"matrix\", found 15", ""},
    {"matrix with perspective",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ matrix = "
     "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0.5,1] }]\n",
     6, 25, "\"matrix\" is not affine", ""},
    {"singular matrix",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ matrix = "
     "[0.1,0.2,0.3,0, 0.4,0.5,0.6,0, 0.7,0.8,0.9,0, 0,0,0,1] }]\n",
     6, 25, "\"matrix\" is singular", ""},
    {"scaled to nothing",
     "[material.m]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\ntransform = [{ scale = 1e-80 "
     "}, { scale = 1e-80 }]\n",
     6, 13, "\"transform\" as a whole is not regular", ""},

    // Names
    {"unknown material", "[material.glass]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"glas\"\n",
     5, 12, "unknown material \"glas\"", "did you mean \"glass\"?"},
    {"no material at all", "[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"red\"\n", 4, 12,
     "unknown material \"red\"", "[material.red]"},
    {"unknown mesh",
     "[material.m]\n[[mesh]]\nname = \"cat\"\nfile = \"cat.ply\"\nmaterial = \"m\"\n[[instance]]\nmesh = "
     "\"cats\"\n",
     7, 8, "unknown mesh \"cats\"", "did you mean \"cat\"?"},
    {"instance of a sphere",
     "[material.m]\n[[sphere]]\nname = \"ball\"\ncenter = [0,0,0]\nradius = 1\nmaterial = "
     "\"m\"\n[[instance]]\nmesh = \"ball\"\n",
     8, 8, "unknown mesh \"ball\"", "[[mesh]]"},
    {"name given twice",
     "[material.m]\n[[sphere]]\nname = \"a\"\ncenter = [0,0,0]\nradius = 1\nmaterial = "
     "\"m\"\n[[sphere]]\nname = \"a\"\ncenter = [0,0,0]\nradius = 1\nmaterial = \"m\"\n",
     8, 8, "another sphere is named \"a\"", "line 3"},
    {"name of a light given twice",
     "[[light]]\ntype = \"ambient\"\nname = \"key\"\n[[light]]\ntype = \"ambient\"\nname = \"key\"\n", 6, 8,
     "another light is named \"key\"", "line 3"},
    {"unknown colour", "[material.m]\ncolor = \"crimsn\"\n", 2, 9, "unknown colour \"crimsn\" for \"color\"",
     "did you mean \"crimson\"?"},
    {"bad hexadecimal colour", "[material.m]\ncolor = \"#12345\"\n", 2, 9, "unknown colour \"#12345\"",
     "#rrggbb"},
    {"energy above 1",
     "[whitted]\nenergy = \"balanced\"\n[material.m]\nreflectivity = 0.75\ntransparency = 0.5\n", 4, 16,
     "material \"m\" has reflectivity + transparency = 1.25", "at most 1"},

    // Places in lines that are not plain ASCII
    {"column in bytes", "[render]\nfilter = \"ä\" # \n  \"ü\" = 1\n", 2, 10, "unknown filter \"ä\"",
     "expected one of"},
    {"CRLF", "[render]\r\nspp = 1\r\nseed = -1\r\n", 3, 8, "\"seed\" must be at least 0", ""},
};

TEST(SceneErrors, EachIsSaidWithPlaceCauseAndCure) {
    const std::string zero_byte("# a\n b\0", 7);
    for (const Malformed& c : malformed) {
        SCOPED_TRACE(c.claim);
        const auto errors = errors_of(c.text ? std::string_view(c.text) : std::string_view(zero_byte));
        ASSERT_FALSE(errors.empty());
        const Diagnostic& first = errors.front();
        EXPECT_EQ(first.severity, Severity::error);
        EXPECT_EQ(first.location.file, "scenes/a.toml");
        EXPECT_EQ(first.location.line, c.line) << first.message;
        if (c.column > 0) {
            EXPECT_EQ(first.location.column, c.column) << first.message;
        }
        EXPECT_NE(first.message.find(c.message), std::string::npos) << first.message;
        EXPECT_NE(first.hint.find(c.hint), std::string::npos) << first.hint;
        EXPECT_FALSE(first.message.ends_with('.')) << first.message;
    }
}

TEST(SceneErrors, AreReportedTogetherInTheOrderOfTheFile) {
    const auto errors = errors_of(R"([whitted]
index = 0
[render]
sppp = 1
filter = "foo"
[[sphere]]
center = [0, 0]
material = "red"
)");
    std::vector<std::pair<int, int>> places;
    for (const Diagnostic& error : errors) places.emplace_back(error.location.line, error.location.column);
    EXPECT_EQ(places, (std::vector<std::pair<int, int>>{{2, 9}, {4, 1}, {5, 10}, {6, 1}, {7, 10}, {8, 12}}));
}

TEST(SceneErrors, OneFaultIsOneError) {
    for (const Malformed& c : malformed) {
        SCOPED_TRACE(c.claim);
        if (std::string_view(c.claim) == "column in bytes") continue; // holds two
        EXPECT_EQ(errors_of(c.text ? c.text : std::string_view("\0", 1)).size(), 1u);
    }
}

TEST(SceneErrors, ShowTheLineAndACaret) {
    try {
        parse("[material.glass]\n[[sphere]]\ncenter = [0,0,0]\nradius = 1\nmaterial = \"glas\"\n");
        FAIL() << "accepted an unknown material";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "scenes/a.toml:5:12: error: unknown material \"glas\"\n"
                                   "    material = \"glas\"\n"
                                   "               ^\n"
                                   "    did you mean \"glass\"?");
    }
}

TEST(SceneErrors, ExcerptsAreFitForATerminal) {
    const auto bad_utf8 = errors_of("a = \"\x1b[31m\xff\"\n");
    ASSERT_EQ(bad_utf8.size(), 1u);
    EXPECT_EQ(bad_utf8[0].excerpt, "a = \"?[31m?\"");
    const auto far_out = errors_of("render = { seed = " + std::string(5000, ' ') + "-1 }\n");
    ASSERT_EQ(far_out.size(), 1u);
    EXPECT_EQ(far_out[0].location.column, 5019);
    EXPECT_EQ(far_out[0].excerpt, "");
    const auto long_name = errors_of(std::string(5000, 'x') + " = 1\n");
    ASSERT_EQ(long_name.size(), 1u);
    EXPECT_LT(to_string(long_name[0]).size(), 1000u);
}

TEST(SceneErrors, ColumnsCountBytesAndTheByteOrderMarkDoesNotCount) {
    const auto errors = errors_of("\xef\xbb\xbfrender = { \"ä\" = 1, seed = -1 }\n");
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_EQ(errors[0].location.column, 12);
    EXPECT_EQ(errors[1].location.column, 29);
}

TEST(SceneErrors, AListOfThousandsIsCutShort) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += "key" + std::to_string(i) + " = 1\n";
    const auto errors = errors_of(text);
    ASSERT_EQ(errors.size(), 1001u);
    EXPECT_EQ(errors.back().message, "4000 further errors are not listed");
}

TEST(SceneErrors, HostileTextEndsInAnError) {
    const auto repeated = [](const std::string& part, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += part;
        return text;
    };
    const std::string hostile[] = {
        "a = " + std::string(100000, '['),
        "a = " + repeated("{b = ", 100000),
        repeated("a.", 100000) + "a = 1",
        "[" + repeated("a.", 100000) + "a]",
        "[" + repeated("\"a,b\".", 100000) + "a]",
        "x = '''" + repeated("a.", 50000) + "'''\n" + repeated("a . ", 50000) + "a = 1",
        "x = \"\\\"" + repeated("a.", 20) + "\"\n" + repeated("'a'.", 100000) + "a = 1",
        repeated("[[sphere]]\n", 20000),
        "sphere = " + std::string("[") + repeated("{},", 20000) + "{}]",
        "\"ä\" = [" + repeated("{},", 20000) + "{}]\nsphere = [" + repeated("{ \"ä\" = 1 },", 20000) + "{}]",
        "[render]\nsize = [" + repeated("1,", 200000) + "1]",
        "x = \"\"\"" + std::string(100000, '\\'),
        std::string(100000, '"'),
        std::string(100000, '\''),
    };
    for (const std::string& text : hostile)
        EXPECT_FALSE(errors_of(text).empty()) << text.substr(0, 20) << " … " << text.size();
}

// Text that a library which takes its own assertions for granted reads past.
TEST(SceneErrors, ShortNonsenseEndsInAnError) {
    for (const char* text :
         {"[=", "[[=", "[]", "[[]]", "[.a]", "[a.]", "=", ".", "a.=1", "a=,", "a=[,]", "a={,}", "a={b}", "\\",
          "c = 1._'''\xc3\xa4\"nan", "a = 1\xc3\xa4", "a = \"\"\"\\\xc3\xa4\"\"\"", "a = +-1", "a = 0x"})
        EXPECT_EQ(errors_of(text).size(), 1u) << text;
    EXPECT_EQ(errors_of("a = \"\"\"\\\n \xc3\xa4\"\"\"").at(0).message, "unknown key \"a\"");
}

TEST(SceneErrors, DottedTextInStringsAndCommentsIsNoKey) {
    const std::string dots = "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a";
    EXPECT_TRUE(
        errors_of("# " + dots + "\n[material.\"" + dots + "\"]\n[material.'" + dots + "b'] # " + dots + "\n")
            .empty());
}

TEST(SceneErrors, NothingIsSaidOfWhatIsRight) {
    EXPECT_TRUE(errors_of(R"(
[camera]
eye = [1_000_000_000_000, -1e12, 0]
look_at = [0, 0, 0x10]
[material.m]
shininess = 0
[[triangle]]
vertices = [[0,0,0], [1,0,0], [0.5,1e-9,0]]
material = "m"
[[plane]]
normal = [0, 0, 1e-3]
offset = 1e9
material = "m"
[[sphere]]
name = "same"
center = [0, 0, 0]
radius = 1e12
material = "m"
transform = []
[[mesh]]
name = "same"
file = "a.ply"
material = "m"
[[instance]]
mesh = "same"
name = "same"
)")
                    .empty());
}

} // namespace
} // namespace glint::test
