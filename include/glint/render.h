#pragma once
// From a frozen scene to a picture.

#include "glint/image.h"
#include "glint/kernels.h"
#include "glint/scene.h"
#include "glint/term.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint {

/// A part of the picture, in pixels from the top left.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

struct Progress {
    std::uint64_t tiles_done = 0;
    std::uint64_t tiles = 0;
    std::uint64_t rays = 0;
    double seconds = 0; ///< wall time since the start of rendering
};

/// What a picture shows of its scene. All but the light and its terms ask one ray through each pixel's
/// centre, whatever the number of samples.
enum class Aov {
    final,   ///< the light: the sum of its terms
    ambient, ///< the terms, in their order; see Term
    diffuse,
    highlight,
    clamp,
    reflection,
    transmission,
    emission,
    shadows, ///< how many lights the first hit does not see; those behind glass count in part
    normal,  ///< the shading normal toward the viewer: x, y, z from −1 to 1; 0 where nothing is hit
    depth,   ///< the distance along the ray, in scene units; infinite where nothing is hit
    cost     ///< steps of a plain walk through the trees to the first hit: nodes, shapes tested, 0
};
inline constexpr int aov_count = 12;
/// "final", "ambient", …
const char* aov_name(Aov aov);

/// A picture for the eye of an aov's numbers, in linear light: the terms as they are, or what they took;
/// shadows from white (all lights are seen) to black (none); normals with −1 … 1 as 0 … 1; depth from white
/// (near) to black, with half the light as far as the scene's middle; cost from black through blue and yellow
/// to white. It depends on the scene and each pixel's numbers alone.
Image visible(const Image& numbers, Aov aov, const Scene& scene);
/// Are an aov's numbers their own picture? The light and the terms that it is the sum of, but for `clamp`.
bool is_visible(Aov aov);

struct RenderOptions {
    Aov show = Aov::final; ///< what Picture::image holds
    int threads = 0;       ///< 0: one for each core
    int tile_size = 16;    ///< pixels; changes the order of the work, never the picture
    std::optional<Rect> crop;
    KernelChoice kernel;   ///< how rays are traced; changes the time, never the picture. Throws where the
                           ///< machine lacks the SIMD target
    bool terms = false;    ///< keep a picture of each term
    bool coverage = false; ///< keep the share of samples that hit something
    std::function<void(const Progress&)> progress; ///< called from rendering threads, one at a time
    const CancelFlag* cancel = nullptr;
};

struct RenderStats {
    double wall_seconds = 0;
    double cpu_seconds = 0;
    double device_seconds = 0; ///< that a graphics card worked
    std::uint64_t primary_rays = 0;
    std::uint64_t reflected_rays = 0;
    std::uint64_t refracted_rays = 0;
    std::uint64_t shadow_rays = 0;
    int threads = 0; ///< threads that rendered at least one tile

    std::uint64_t rays() const { return primary_rays + reflected_rays + refracted_rays + shadow_rays; }
};

struct Picture {
    Image image;
    std::array<Image, term_count>
        terms; ///< by Term; their sum in order is `image` to the bit; empty unless asked for
    std::vector<float> coverage; ///< width · height: share of the samples that hit something; or empty
    RenderStats stats;
    bool complete = true; ///< false: cancelled; pixels of unfinished tiles are 0
};

/// Renders the scene by its own settings. The picture depends on scene and settings alone: not on threads or
/// tiles. With a crop, the picture has the crop's size and holds exactly these pixels of the whole.
Picture render(const Scene& scene, const RenderOptions& options = {});

/// The settings that decide the picture, for metadata: version, size, samples, seed, filter, integrator,
/// depth …
std::vector<std::pair<std::string, std::string>> picture_settings(const Scene& scene);

/// The version of the library, "0.1.0".
const char* version();

} // namespace glint
