#pragma once
// Rendering pictures of scenes.

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

/// A rectangle in pixels from the top left.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

struct Progress {
    std::uint64_t tiles_done = 0;
    std::uint64_t tiles = 0; ///< of the passes so far; a picture that is coarse first has several
    double fraction = 0;     ///< of all samples that are done
    std::uint64_t rays = 0;
    double seconds = 0; ///< wall time since the start of rendering
};

/// What a picture contains: the light, one of its terms, or another output channel (AOV). All except the
/// light and its terms use one ray through each pixel's centre, whatever the number of samples.
enum class Aov {
    final,   ///< the light: the sum of its terms
    ambient, ///< the terms of Whitted's model in order, see Term
    diffuse,
    highlight,
    clamp,
    reflection,
    transmission,
    emission, ///< also of path tracing
    shadows,  ///< number of lights not visible from the first hit; those behind glass count fractionally
    normal,   ///< shading normal facing the viewer: x, y, z from −1 to 1; 0 if nothing is hit
    depth,    ///< distance along the ray in scene units; infinite if nothing is hit
    cost,     ///< steps of scalar traversal to the first hit: nodes, shapes tested, 0
    direct_diffuse, ///< the terms of path tracing in order, see PathTerm
    direct_specular,
    direct_transmission,
    indirect_diffuse,
    indirect_specular,
    indirect_transmission
};
inline constexpr int aov_count = 18;
/// "final", "ambient", …
const char* aov_name(Aov aov);
/// Whether pictures of the integrator have it: only terms depend on the integrator.
bool has_aov(Integrator integrator, Aov aov);
/// The names of an integrator's terms in order; none if it does not split light.
std::vector<std::string> term_names(Integrator integrator);

/// A picture for the eye of an aov's numbers, in linear light: the terms as they are, or what they took;
/// shadows from white (all lights are seen) to black (none); normals with −1 … 1 as 0 … 1; depth from white
/// (near) to black, with half the light as far as the scene's middle; cost from black through blue and yellow
/// to white. It depends on the scene and each pixel's numbers alone.
Image visible(const Image& numbers, Aov aov, const Scene& scene);
/// Are an aov's numbers their own picture? The light and the terms that it is the sum of, but for `clamp`.
bool is_visible(Aov aov);

struct RenderOptions {
    Aov show = Aov::final; ///< contents of Picture::image
    int threads = 0;       ///< 0: one for each processor that may be used
    int tile_size = 16;    ///< in pixels; affects the order of work, never the picture
    std::optional<Rect> crop;
    KernelChoice kernel; ///< traversal kernel; affects time, never the picture. Throws if the machine lacks
                         ///< the SIMD target
    bool terms = false;  ///< return a picture of each term
    /// Return the fraction of samples that hit something, and leave out the background: the image is then
    /// premultiplied by this fraction.
    bool coverage = false;
    /// Measure a coarse picture first, which unfinished tiles show if rendering is cancelled. It takes some
    /// time, and changes no finished picture.
    bool coarse_first = false;
    std::function<void(const Progress&)>
        progress; ///< called at the start, then by rendering threads, one at a time
    const CancelFlag* cancel = nullptr;
};

struct RenderStats {
    double wall_seconds = 0;
    double cpu_seconds = 0;
    double device_seconds = 0; ///< time on a graphics card
    std::uint64_t primary_rays = 0;
    std::uint64_t reflected_rays = 0;
    std::uint64_t refracted_rays = 0;
    std::uint64_t shadow_rays = 0;
    std::uint64_t left_out_rays = 0; ///< not traced: their weight was below WhittedSettings::min_weight
    double light = 0;                ///< of all samples, if PathSettings::clamp_indirect is set
    double clamped_light = 0;        ///< what that took of it
    int threads = 0;                 ///< threads that rendered at least one tile

    std::uint64_t rays() const { return primary_rays + reflected_rays + refracted_rays + shadow_rays; }
};

/// Bound on the mean share of a sample's light that the rays left out would have brought: their number times
/// min_weight. The picture is darker by at most this share of the brightest light along any ray.
double left_out_share(const RenderStats& stats, const Scene& scene);

/// The share of the light that PathSettings::clamp_indirect took; 0 if it is not set.
double clamped_share(const RenderStats& stats);

struct Picture {
    Image image;
    /// by Term or PathTerm; their sum in order equals `image` bit for bit; empty unless requested
    std::array<Image, term_count> terms;
    std::vector<float>
        coverage; ///< width · height: fraction of samples that hit something, filtered; or empty
    RenderStats stats;
    bool complete = true; ///< false if cancelled; unfinished tiles are coarse (coarse_first) or 0
};

/// Renders the scene with its own settings. The picture depends only on scene and settings, not on threads or
/// tiles. With a crop, it has the crop's size and contains exactly these pixels.
Picture render(const Scene& scene, const RenderOptions& options = {});

/// Settings that determine the picture, for metadata: version, size, samples, seed, filter, integrator, depth
/// …
std::vector<std::pair<std::string, std::string>> picture_settings(const Scene& scene);

/// Version of the library, such as "0.1.0".
const char* version();

} // namespace glint
