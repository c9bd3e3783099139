// Rendering a frame with camera, shadow and mirror rays.

#include "jobs.h"
#include "rays.h"

#include <algorithm>
#include <array>
#include <limits>

namespace glint::bench {
namespace {

constexpr std::size_t tile_pixels = 64;
constexpr int tile_side = 8;

/// Up to 64 rays and their pixels.
struct TileRays {
    std::array<Ray, tile_pixels> rays;
    std::array<std::size_t, tile_pixels> pixel;
    std::size_t count = 0;

    void add(const Ray& ray, std::size_t for_pixel) {
        rays[count] = ray;
        pixel[count++] = for_pixel;
    }
    std::span<const Ray> span() const { return {rays.data(), count}; }
};

float diffuse(const Start& start, const vec3& light) {
    return std::max(0.0f, glm::dot(start.normal, glm::normalize(light - start.origin)));
}

/// A tile: camera rays, then a shadow ray and a mirror ray for each hit; mirror hits are shaded without
/// shadows.
class Tile {
  public:
    Tile(const Model& model, int size, std::size_t number) : model_(model) {
        const int tiles = size / tile_side;
        const int left = static_cast<int>(number) % tiles * tile_side;
        const int top = static_cast<int>(number) / tiles * tile_side;
        for (int pixel = 0; pixel < static_cast<int>(tile_pixels); ++pixel)
            camera_[static_cast<std::size_t>(pixel)] =
                camera_ray(model.camera, size, left + pixel % tile_side, top + pixel / tile_side);
    }

    void render(const Peer& peer, float* pixels) {
        std::array<Hit, tile_pixels> hits;
        peer.closest(camera_, hits, RayHint::coherent);
        for (std::size_t i = 0; i < tile_pixels; ++i)
            if (hits[i]) spawn(camera_[i], hits[i], i);

        std::array<std::uint8_t, tile_pixels> blocked;
        peer.occluded(shadow_.span(), {blocked.data(), shadow_.count}, RayHint::coherent);
        peer.closest(mirror_.span(), {hits.data(), mirror_.count}, RayHint::coherent);
        std::fill_n(pixels, tile_pixels, 0.1f);
        for (std::size_t k = 0; k < shadow_.count; ++k) {
            Start seen;
            const bool reflects = hits[k] && find_start(model_, mirror_.rays[k], hits[k], seen);
            pixels[shadow_.pixel[k]] = (blocked[k] != 0 ? 0.0f : 0.7f * lit_[k]) +
                                       0.3f * (reflects ? diffuse(seen, model_.light) : 0.1f);
        }
    }

    std::size_t rays() const { return tile_pixels + shadow_.count + mirror_.count; }

  private:
    void spawn(const Ray& ray, const Hit& hit, std::size_t pixel) {
        Start start;
        if (!find_start(model_, ray, hit, start)) return;
        const vec3 way = direction_of(ray);
        const vec3 reflected = way - start.normal * (2.0f * glm::dot(start.normal, way));
        lit_[shadow_.count] = diffuse(start, model_.light);
        shadow_.add(make_ray(start.origin, model_.light - start.origin, 1.0f), pixel);
        mirror_.add(make_ray(start.origin, reflected, std::numeric_limits<float>::infinity()), pixel);
    }

    const Model& model_;
    std::array<Ray, tile_pixels> camera_;
    std::array<float, tile_pixels> lit_;
    TileRays shadow_;
    TileRays mirror_;
};

} // namespace

Job frame_job(const Model& model, const tracing::Mesh& reference, const JobOptions& options) {
    const int size = options.size;
    const auto side = static_cast<std::size_t>(size / tile_side);
    Job job{"frame", 0, side * side, {}, {}};
    job.empty_answers.image.resize(side * side * tile_pixels);
    job.run = [&model, size](const Peer& peer, std::size_t number, Answers& answers) {
        Tile(model, size, number).render(peer, answers.image.data() + number * tile_pixels);
    };

    // All peers are credited with the reference's number of rays.
    const Peer counter = our_peer(reference);
    std::array<float, tile_pixels> pixels;
    for (std::size_t number = 0; number < job.batches; ++number) {
        Tile tile(model, size, number);
        tile.render(counter, pixels.data());
        job.rays += tile.rays();
    }
    return job;
}

} // namespace glint::bench
