#pragma once
// The film: which samples of each tile are done, the sums of unfinished pixels, and the picture.

#include "glint/render.h"
#include "imaging/pixel_sum.h"
#include "parallel/task_pool.h"
#include "render/camera_sample.h"
#include "render/schedule.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint::rendering {

/// What a film measures and stores.
struct FilmLayout {
    Rect area;               ///< pixels of the whole picture: those that are measured
    Rect kept;               ///< those of them that the picture shows; the others are only compared
    int tile_size = 16;      ///< pixels
    SampleCounts samples;    ///< of a finished pixel
    Aov show = Aov::final;   ///< what is measured
    std::optional<int> term; ///< shown by the image instead of the radiance
    bool terms = false;      ///< keep an image of each term
    bool coverage = false;   ///< keep the share of samples that hit something
};

/// The layout of a picture. AOVs of first hits have one sample, no terms and no coverage. Throws Error(usage)
/// for a crop that does not lie inside the picture.
FilmLayout film_layout(const RenderSettings& settings, const RenderOptions& options);

/// The sums of a pixel that will get more samples. T is Terms or, for one channel, vec3.
template <class T>
struct PixelState {
    typename imaging::PixelSum<T>::Part sum;
    imaging::CoveredCounts covered;
};

/// The values of one visit of a tile. They enter the film when all are there, so that a cancelled visit
/// leaves no trace.
struct FilmTile {
    std::vector<Pixel> pixels;     ///< of the area: those measured
    std::vector<vec3> shown;       ///< by pixel
    std::vector<Terms> terms;      ///< by pixel, if the film stores them
    std::vector<float> coverage;   ///< by pixel, if the film stores it
    std::vector<std::byte> states; ///< PixelState by pixel of the tile, if more samples will follow

    void resize_to_pixels(const FilmLayout& layout) {
        shown.resize(pixels.size());
        if (layout.terms) terms.resize(pixels.size());
        if (layout.coverage) coverage.resize(pixels.size());
    }
};

/// The images that a film keeps, each of all pixels or empty.
struct FilmImages {
    Image image;
    std::array<Image, term_count> terms;
    std::vector<float> coverage; ///< by pixel
};

class FilmReader;

/// Threads may read and commit at the same time if each works on other tiles.
class Film {
  public:
    Film() = default;
    explicit Film(const FilmLayout& layout) { start(layout); }

    /// Forgets all samples, but keeps its memory and, until a pass changes it, the image.
    void start(const FilmLayout& layout);
    /// Allocates the images of a pass. Those of another size become black.
    void begin_pass(const Pass& pass);

    const FilmLayout& layout() const { return layout_; }
    const TileGrid& tiles() const { return grid_; }

    /// Samples of a finished pixel; after refine(), of one that is refined.
    int samples() const { return is_refined() ? layout_.samples.differing : layout_.samples.all; }
    /// True if each term is summed; otherwise one channel is: the radiance, a single term or an AOV.
    bool sums_terms() const { return layout_.terms || (samples() > 1 && !layout_.term); }

    /// Begins the adaptive passes, if they have not begun: the pixels that differ from a neighbour get new
    /// samples, the others are finished. All must have those of the passes before.
    void refine(parallel::TaskPool& pool);
    bool is_refined() const { return !refined_.empty(); }
    /// True if this pixel of the area is measured: after refine(), if it is refined.
    bool takes(const Pixel& pixel) const { return !is_refined() || refined_[index(pixel)] != 0; }

    /// The samples of a pass that a tile lacks, as far as the next visit takes them: none if their count is
    /// 0. After its commit() there may be more.
    Pass missing(std::size_t tile, const Pass& pass) const;
    /// True if a visit from missing() adds to the sums of all samples before it; otherwise it has its own
    /// sums.
    bool continues(std::size_t tile, const Pass& visit) const;
    /// The state that a visit continues, of the pixel with this index in the tile.
    template <class T>
    PixelState<T> state(std::size_t tile, std::size_t pixel) const;
    /// False if the visit completes its pixels, so that their states are not needed.
    bool keeps_states(std::size_t tile, const Pass& visit) const;
    std::size_t state_bytes(std::size_t tile) const; ///< of all pixels of a tile

    /// Stores a visit from missing(), which measured every pixel of the tile that the film takes.
    void commit(std::size_t tile, const Pass& visit, FilmTile& values);
    /// Stores centres of a preview pass.
    void commit_preview(const Pass& pass, const FilmTile& values);
    /// Ends a preview pass: the images show its pixels and, of light, interpolate between them. Terms are
    /// copied instead, so that their sum remains the picture to the bit.
    void show_preview(const Pass& pass, parallel::TaskPool& pool);
    /// Sets a pixel of the area from sums made elsewhere: all that a pass adds to it.
    void set_pixel(const Pass& pass, const Pixel& pixel, const imaging::SignedSums<Terms>& sums,
                   const imaging::CoveredCounts& covered);

    const Image& image() const { return images_.image; }
    /// Moves the images and the coverage into a picture.
    void move_to(Picture& picture);
    /// True if any tile has samples, which previews would overwrite.
    bool has_samples() const;
    /// True if every pixel that takes() accepts has samples() samples.
    bool has_all_samples() const;
    /// True if every pixel has all its samples.
    bool is_complete() const;

    /// Adds the samples of a film of another shard. A pixel that becomes complete has the bits that it has in
    /// a film that was rendered at once. Throws Error(usage), and changes nothing, if the layouts differ or
    /// both have the same samples.
    void join(const Film& other);

    /// Samples, sums and finished pixels as bytes, versioned and with a check sum.
    std::vector<std::byte> save() const;
    /// Throws Error(input) for bytes that save() did not write, or that were damaged.
    static Film load(std::span<const std::byte> bytes);

  private:
    /// Samples first … first + count − 1 of all pixels of a tile: an aligned block of a power of two, or all
    /// that are left, so that sums of blocks are trees of the whole sum.
    struct SampleBlock {
        int first = 0;
        int count = 0;
        std::vector<std::byte> states; ///< PixelState by pixel of the tile; unused if all samples are done

        int end() const { return first + count; }
    };
    struct TileSamples {
        std::vector<SampleBlock> blocks; ///< disjoint and in ascending order
        std::vector<std::byte> spare;    ///< memory of former states
    };

    void fit(FilmImages& images) const;
    FilmImages& images_of(const Pass& pass) { return pass.step > 1 ? preview_ : images_; }
    void write(const FilmTile& values, FilmImages& images) const;
    bool is_complete(const TileSamples& tile) const;
    std::size_t pixels_of(std::size_t tile) const;
    void insert(TileSamples& tile, SampleBlock block) const;
    void merge_blocks(std::size_t tile);
    template <class T>
    void merge_and_show(std::size_t tile);
    template <class T>
    static void add_states(SampleBlock& before, const SampleBlock& after);
    template <class T>
    void show_blocks(std::size_t tile);
    template <class T>
    void show(const Pixel& pixel, const T& value, float coverage, FilmImages& images) const;
    void copy_pixels(std::size_t tile, const Film& from);
    /// Calls f(row of floats) for each row of a tile in each image that the film keeps.
    template <class AnyFilm, class F>
    static void for_rows(AnyFilm& film, std::size_t tile, const F& f);
    void save_tile(std::size_t tile, std::vector<std::byte>& out) const;
    void load_tile(std::size_t tile, FilmReader& in);
    bool is_sound(const TileSamples& tile) const;
    std::size_t index(const Pixel& pixel) const {
        return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(layout_.area.width) +
               static_cast<std::size_t>(pixel.x);
    }

    FilmLayout layout_;
    TileGrid grid_;
    std::vector<TileSamples> samples_;  ///< by tile
    std::vector<std::uint8_t> refined_; ///< by pixel: gets new samples; empty before refine()
    FilmImages images_;
    FilmImages preview_; ///< centres, at the pixels that were measured
};

} // namespace glint::rendering
