#pragma once
// Files: scenes, meshes, pictures. Every reader throws Error(input) with place, cause and cure; every writer
// writes the whole file or nothing and throws Error(output).

#include "glint/error.h"
#include "glint/explanation.h"
#include "glint/image.h"
#include "glint/scene.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

// ── Scenes ─────────────────────────────────────────────────────────────────────────────────────────────────

/// `path=value`, as given by -D: "whitted.max_depth=3", "material.glass.index=1.33", "light.0.intensity=500".
using Override = std::string;

struct LoadOptions {
    std::vector<Override> overrides;
    bool allow_outside = false; ///< may a scene name files outside its own folder?
    bool load_meshes = true;
    std::optional<Axis> up;             ///< for bare meshes; none: guessed, and said in `notes`
    const CancelFlag* cancel = nullptr; ///< once it is set, Error(cancelled) is thrown
    LoadCallback progress;              ///< told of meshes as they are read
};

class OpenScene;

/// How a scene moves: what its [animation] and [[animate]] tables say.
struct Animation {
    int first = 0;
    int last = 0; ///< the last keyframe where the file names none
    double fps = 24;
    std::vector<std::string> keys;          ///< the key paths that move, in the order of the file
    std::shared_ptr<const OpenScene> scene; ///< for scene_at(); null where nothing moves
};

struct LoadedScene {
    SceneDescription description;
    std::vector<Diagnostic> warnings; ///< of the files; those of meaning come from glint::warnings()
    std::vector<std::string> files; ///< that decide it, each once: the scene file, then its meshes. Not stdin
    Animation animation;
    std::vector<std::string> notes; ///< choices made for the user, one line each ("up axis: y (guessed) …")
};

/// Reads a scene file, or stages a bare mesh, judged by the extension and then by the content. "-" reads a
/// scene from stdin. All errors of meaning are reported together.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

/// The same from text; `name` stands for the file in messages and its folder for relative names.
LoadedScene parse_scene(std::string_view text, const std::string& name, const LoadOptions& options = {});

/// The scene at a frame, which may lie between whole ones. Overrides have the last word over what moves.
/// Meshes are the same objects at every frame, so that what does not move can be told. Throws Error(input),
/// naming the frame, where the scene is wrong there. May be called from any number of threads.
SceneDescription scene_at(const LoadedScene& scene, double frame);

/// The reference page of all keys, Markdown, generated from the table that drives the parser.
std::string scene_key_reference();

/// Names of the starter scenes of `glint new`, and the commented text of one.
std::vector<std::string> template_names();
std::string template_text(const std::string& name);

// ── Meshes ─────────────────────────────────────────────────────────────────────────────────────────────────

struct LoadedMesh {
    std::shared_ptr<const Mesh> mesh;
    std::vector<Diagnostic> warnings;
};

/// Reads a PLY file: ASCII, binary little or big endian. Of the options only `cancel` and `progress` count.
LoadedMesh load_mesh(const std::string& path, const LoadOptions& options = {});

/// The same from memory; `name` stands for the file in messages.
LoadedMesh parse_ply(std::span<const std::byte> bytes, const std::string& name,
                     const LoadOptions& options = {});

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

/// Writes positions, normals, colours, texture coordinates and triangles as PLY; reading gives the same bits.
void write_ply(const std::string& path, const Mesh& mesh, PlyFormat format = PlyFormat::binary_little_endian);

// ── Pictures ───────────────────────────────────────────────────────────────────────────────────────────────

enum class View { srgb, raw };

/// One named picture beside the main one: a term of the light, or coverage.
struct Layer {
    std::string name;
    Image image;
};

struct PictureOptions {
    View view = View::srgb;
    int bits = 8;              ///< PNG: 8 or 16
    std::vector<float> alpha;  ///< PNG, EXR: width · height values, straight; empty: none
    std::vector<Layer> layers; ///< EXR
    std::vector<std::pair<std::string, std::string>>
        metadata; ///< what decides the picture; PNG text, EXR attributes
};

/// What a screen shows of a picture: the codes that an 8-bit PNG would hold, a pixel packed as 0xffRRGGBB,
/// rows from the top. `pixels` takes the picture's size.
void screen_pixels(const Image& image, View view, std::vector<std::uint32_t>& pixels);

/// Writes .png, .exr or .pfm by the extension; "-" is stdout (as PNG).
void write_picture(const std::string& path, const Image& image, const PictureOptions& options = {});

/// Throws what write_picture() would throw for the path alone: Error(usage) for an extension that is none of
/// the three or cannot hold alpha or layers, Error(output) for a missing folder or permission. Writes
/// nothing: call it before a long render.
void check_picture_target(const std::string& path, bool with_alpha = false, bool with_layers = false);

/// A picture as read: 8- and 16-bit ones hold their integer values, float ones linear light.
struct LoadedPicture {
    Image image;
    int bits = 32; ///< 8, 16, or 32 for float
};
LoadedPicture read_picture(const std::string& path);

/// What `glint diff` compares: |a − b| in units of 1/255 where both pictures have 8 or 16 bits, linear light
/// where both are float. One of each is refused with Error(usage), different sizes with Error(input).
struct PictureDifference {
    Comparison comparison;
    bool eight_bit = false; ///< units of 1/255
};
PictureDifference diff_pictures(const LoadedPicture& a, const LoadedPicture& b, double tolerance);

// ── Explanations ───────────────────────────────────────────────────────────────────────────────────────────

/// A readable tree of 6 digits, UTF-8; `color` adds a terminal's escape sequences.
std::string explanation_text(const Explanation& explanation, bool color = false);

/// "0.5", or "(1, 0, 0.25)".
std::string quantity_text(const Quantity& q, int digits = 6);

/// The formula of a step with its numbers for its symbols, as explanation_text() prints it; empty where it
/// would say no more than the formula or the result. `light`: whose step it is, else the ray's own.
std::string formula_in_numbers(const Step& step, const ExplainedRay& ray,
                               const ExplainedLight* light = nullptr);

/// What a graphics card makes of the pixel, and how far that is from the explanation:
/// "on DEVICE it is (…), off by at most …".
std::string other_pixel_text(const Explanation& explanation, const OtherPixel& other, int digits = 6);

/// JSON with nine digits, which read back as the same floats; docs/explain.md lists the names.
std::string explanation_json(const Explanation& explanation);

/// A picture of the trees: SVG, for reading and for showing around.
std::string explanation_svg(const Explanation& explanation);

/// What explanation_html() makes a page of.
struct ExplanationPage {
    std::string scene;                   ///< title
    Image image;                         ///< the picture, and
    std::array<Image, term_count> terms; ///< its terms, as render() gives them
    std::string gpu;                     ///< the graphics card that rendered gpu_image; empty: none did
    Image gpu_image;                     ///< the picture from there, to be compared with
    int columns = 160; ///< the page holds the explanations of so many places, at most one a pixel:
    int rows = 90;     ///< the middles of an even grid
    /// Asked for the places of one row after the other; of each the rays of its first sample are shown.
    std::function<std::vector<Explanation>(std::span<const PixelPlace> row)> explain;
    std::size_t most_bytes = 9'900'000; ///< rays that bring least are left out until the page is no larger
};

/// A picture that can be asked, as one HTML file that needs no network: its terms can be switched on and off,
/// and where the mouse is, the rays of the place are shown with every term.
std::string explanation_html(const ExplanationPage& page);

// ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Writes a file under a temporary name in the same folder, fsyncs, renames: whole or not at all.
void write_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace glint
