// The film: samples, their sums, joining of films.

#include "render/film.h"

#include "glint/error.h"
#include "glint/limits.h"
#include "parallel/large_pages.h"
#include "render/aov.h"
#include "render/contrast.h"
#include "render/upsample.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace glint::rendering {
namespace {

bool is_power_of_two(int n) { return std::has_single_bit(static_cast<unsigned>(n)); }

/// The largest power of two that divides n > 0: the size of the largest block that may begin at sample n.
int alignment(int n) { return n & -n; }

/// Reallocates the image, in large pages, if its size differs.
void fit_image(Image& image, const Rect& area) {
    if (image.width == area.width && image.height == area.height) return;
    const std::size_t values =
        3 * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
    image = {};
    image.width = area.width;
    image.height = area.height;
    parallel::reserve_large(image.pixels, values);
    image.pixels.resize(values);
}

void write_color(float* pixel, const vec3& value) {
    pixel[0] = value.x;
    pixel[1] = value.y;
    pixel[2] = value.z;
}

bool same(const Rect& a, const Rect& b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

/// The name of what two layouts differ in; null if they are equal.
const char* difference(const FilmLayout& a, const FilmLayout& b) {
    if (!same(a.area, b.area) || !same(a.kept, b.kept)) return "area";
    if (a.tile_size != b.tile_size) return "tile size";
    if (a.samples != b.samples) return "samples per pixel";
    if (a.show != b.show) return "quantity";
    if (a.term != b.term || a.terms != b.terms) return "terms";
    if (a.coverage != b.coverage) return "coverage";
    return nullptr;
}

/// The crop, or all of the picture.
Rect picture_area(const RenderSettings& settings, const std::optional<Rect>& crop) {
    if (!crop) return {0, 0, settings.width, settings.height};
    const Rect c = *crop;
    const bool inside = c.x >= 0 && c.y >= 0 && c.width >= 1 && c.height >= 1 &&
                        c.width <= settings.width - c.x && c.height <= settings.height - c.y;
    if (inside) return c;
    throw Error(ErrorKind::usage, "the crop does not lie inside the picture",
                "expected x, y, width, height within " + std::to_string(settings.width) + "x" +
                    std::to_string(settings.height));
}

/// The pixels of an area and those around it, as far as the picture has them.
Rect with_neighbours(const Rect& area, const RenderSettings& settings) {
    const int x = std::max(0, area.x - 1), y = std::max(0, area.y - 1);
    return {x, y, std::min(settings.width, area.x + area.width + 1) - x,
            std::min(settings.height, area.y + area.height + 1) - y};
}

/// Keeps only a part of an image.
void cut(std::vector<float>& values, const Layout& layout, const Rect& part) {
    const std::size_t row = static_cast<std::size_t>(part.width) * static_cast<std::size_t>(layout.channels);
    for (int y = 0; y < part.height && !values.empty(); ++y)
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(layout.at(part.x, part.y + y)), row,
                    values.begin() + static_cast<std::ptrdiff_t>(row) * y);
    values.resize(std::min(values.size(), row * static_cast<std::size_t>(part.height)));
}

void require_terms(Integrator integrator, const RenderOptions& options) {
    const std::vector<std::string> names = term_names(integrator);
    const std::string subject = "the integrator " + std::string(name_of(integrator));
    if (names.empty() && (options.terms || options.show != Aov::final))
        throw Error(ErrorKind::usage, subject + " does not split light into terms",
                    "--integrator whitted does, and path");
    if (has_aov(integrator, options.show)) return;
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw Error(ErrorKind::usage, subject + " has no term " + aov_name(options.show), "its terms: " + list);
}

} // namespace

FilmLayout film_layout(const RenderSettings& settings, const RenderOptions& options) {
    FilmLayout layout;
    layout.area = layout.kept = picture_area(settings, options.crop);
    layout.tile_size = std::clamp(options.tile_size, 1, picture_side_limit);
    layout.show = options.show;
    if (!is_light(options.show)) return layout;
    layout.samples = sample_counts(settings);
    if (layout.samples.adaptive()) layout.area = with_neighbours(layout.kept, settings);
    require_terms(settings.integrator, options);
    layout.term = term_of(options.show, settings.integrator);
    layout.terms = options.terms;
    layout.coverage = options.coverage;
    return layout;
}

void Film::start(const FilmLayout& layout) {
    layout_ = layout;
    grid_ = TileGrid(layout.area.width, layout.area.height, layout.tile_size);
    samples_.resize(grid_.count());
    refined_.clear();
    for (TileSamples& tile : samples_) {
        if (!tile.blocks.empty()) tile.spare.swap(tile.blocks.front().states);
        tile.blocks.clear();
    }
}

void Film::begin_pass(const Pass& pass) { fit(images_of(pass)); }

void Film::fit(FilmImages& images) const {
    fit_image(images.image, layout_.area);
    for (Image& term : images.terms) fit_image(term, layout_.terms ? layout_.area : Rect{});
    const std::size_t pixels = layout_.coverage ? index({0, layout_.area.height}) : 0;
    if (images.coverage.size() != pixels) images.coverage.assign(pixels, 0.0f);
}

// ── Samples ──

void Film::refine(parallel::TaskPool& pool) {
    if (is_refined()) return;
    Rect kept = layout_.kept;
    kept.x -= layout_.area.x;
    kept.y -= layout_.area.y;
    refined_ = pixels_that_differ(images_.image, images_.coverage, kept, pool);
    for (TileSamples& tile : samples_) tile.blocks.clear();
}

Pass Film::missing(std::size_t tile, const Pass& pass) const {
    if (is_refined() && !pass.adaptive) return {};
    int first = pass.first;
    int end = pass.first + pass.count;
    for (const SampleBlock& block : samples_[tile].blocks) {
        if (block.end() <= first) continue;
        if (block.first > first) {
            end = std::min(end, block.first);
            break;
        }
        first = block.end();
    }
    Pass visit = pass;
    visit.first = first;
    visit.count = std::max(0, end - first);
    if (visit.count == 0 || continues(tile, visit)) return visit;
    // With sums of its own, it must be a tree of the whole sum.
    if (first > 0) visit.count = std::min(visit.count, alignment(first));
    if (first + visit.count < samples())
        visit.count = static_cast<int>(std::bit_floor(static_cast<unsigned>(visit.count)));
    return visit;
}

bool Film::continues(std::size_t tile, const Pass& visit) const {
    const auto& blocks = samples_[tile].blocks;
    const int end = visit.first + visit.count;
    return !blocks.empty() && blocks.front().first == 0 && blocks.front().count == visit.first &&
           (end == samples() || is_power_of_two(end));
}

template <class T>
PixelState<T> Film::state(std::size_t tile, std::size_t pixel) const {
    PixelState<T> state;
    std::memcpy(&state, &samples_[tile].blocks.front().states[pixel * sizeof state], sizeof state);
    return state;
}

bool Film::keeps_states(std::size_t tile, const Pass& visit) const {
    const bool starts = visit.first == 0 || continues(tile, visit);
    return !starts || visit.first + visit.count < samples();
}

bool Film::is_complete(const TileSamples& tile) const {
    return !tile.blocks.empty() && tile.blocks.front().count == samples();
}

bool Film::has_samples() const {
    return is_refined() || std::any_of(samples_.begin(), samples_.end(),
                                       [](const TileSamples& tile) { return !tile.blocks.empty(); });
}

bool Film::is_complete() const { return has_all_samples() && is_refined() == layout_.samples.adaptive(); }

bool Film::has_all_samples() const {
    return std::all_of(samples_.begin(), samples_.end(),
                       [this](const TileSamples& tile) { return is_complete(tile); });
}

std::size_t Film::state_bytes(std::size_t tile) const {
    return pixels_of(tile) * (sums_terms() ? sizeof(PixelState<Terms>) : sizeof(PixelState<vec3>));
}

std::size_t Film::pixels_of(std::size_t tile) const {
    const Rect r = grid_.tile(tile);
    return static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height);
}

void Film::commit(std::size_t tile, const Pass& visit, FilmTile& values) {
    const int end = visit.first + visit.count;
    const bool continued = continues(tile, visit);
    write(values, images_);
    TileSamples& samples_of_tile = samples_[tile];
    const bool keeps = keeps_states(tile, visit);
    if (continued) {
        samples_of_tile.blocks.front().count = end;
        if (keeps) samples_of_tile.blocks.front().states.swap(values.states);
    } else {
        SampleBlock block{visit.first, visit.count, {}};
        block.states.swap(samples_of_tile.spare);
        if (keeps) block.states.swap(values.states);
        insert(samples_of_tile, std::move(block));
    }
    if (samples_of_tile.blocks.size() > 1) merge_blocks(tile);
}

void Film::insert(TileSamples& tile, SampleBlock block) const {
    const auto after = std::find_if(tile.blocks.begin(), tile.blocks.end(),
                                    [&](const SampleBlock& b) { return b.first > block.first; });
    tile.blocks.insert(after, std::move(block));
}

// ── Blocks of samples with sums of their own ──

void Film::merge_blocks(std::size_t tile) {
    sums_terms() ? merge_and_show<Terms>(tile) : merge_and_show<vec3>(tile);
}

/// Joins neighbours that make a larger tree, as carries run through a binary counter.
template <class T>
void Film::merge_and_show(std::size_t tile) {
    auto& blocks = samples_[tile].blocks;
    for (std::size_t i = 1; i < blocks.size();) {
        SampleBlock& before = blocks[i - 1];
        const SampleBlock& after = blocks[i];
        const bool is_tree = before.end() == after.first && before.count == after.count &&
                             before.first % (2 * before.count) == 0 && is_power_of_two(before.count);
        if (!is_tree) {
            ++i;
            continue;
        }
        add_states<T>(before, after);
        before.count += after.count;
        blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(i));
        i = std::max<std::size_t>(i - 1, 1);
    }
    show_blocks<T>(tile);
}

template <class T>
void Film::add_states(SampleBlock& before, const SampleBlock& after) {
    for (std::size_t at = 0; at < before.states.size(); at += sizeof(PixelState<T>)) {
        PixelState<T> a, b;
        std::memcpy(&a, &before.states[at], sizeof a);
        std::memcpy(&b, &after.states[at], sizeof b);
        a.sum = a.sum + b.sum;
        a.covered = a.covered + b.covered;
        std::memcpy(&before.states[at], &a, sizeof a);
    }
}

/// Shows the mean of all samples of a tile. Blocks that do not fill a tree are added at the end, the last one
/// first, as in PairwiseSum.
template <class T>
void Film::show_blocks(std::size_t tile) {
    auto& blocks = samples_[tile].blocks;
    int count = 0;
    for (const SampleBlock& block : blocks) count += block.count;
    const Rect r = grid_.tile(tile);
    for (std::size_t i = 0; i < pixels_of(tile); ++i) {
        const auto width = static_cast<std::size_t>(r.width);
        const Pixel pixel{r.x + static_cast<int>(i % width), r.y + static_cast<int>(i / width)};
        if (!takes(pixel)) continue;
        const std::size_t at = i * sizeof(PixelState<T>);
        PixelState<T> all;
        std::memcpy(&all, &blocks.back().states[at], sizeof all);
        for (std::size_t block = blocks.size() - 1; block-- > 0;) {
            PixelState<T> before;
            std::memcpy(&before, &blocks[block].states[at], sizeof before);
            all.sum = before.sum + all.sum;
            all.covered = before.covered + all.covered;
        }
        const imaging::SignedSums<T> sums{all.sum.positive, all.sum.negative,
                                          static_cast<std::uint32_t>(count), all.sum.positives};
        show(pixel, imaging::pixel_value(sums),
             imaging::pixel_coverage(all.covered, sums.count, sums.positives), images_);
    }
    if (count == samples()) {
        blocks.resize(1);
        blocks.front().count = count;
    }
}

// ── Pixels ──

void Film::write(const FilmTile& values, FilmImages& images) const {
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        const Pixel& pixel = values.pixels[i];
        write_color(images.image.at(pixel.x, pixel.y), values.shown[i]);
        for (std::size_t t = 0; layout_.terms && t < images.terms.size(); ++t)
            write_color(images.terms[t].at(pixel.x, pixel.y), values.terms[i].value[t]);
        if (layout_.coverage) images.coverage[index(pixel)] = values.coverage[i];
    }
}

template <class T>
void Film::show(const Pixel& pixel, const T& value, float coverage, FilmImages& images) const {
    if constexpr (std::is_same_v<T, Terms>) {
        write_color(images.image.at(pixel.x, pixel.y), value.sum(layout_.term));
        for (std::size_t t = 0; layout_.terms && t < images.terms.size(); ++t)
            write_color(images.terms[t].at(pixel.x, pixel.y), value.value[t]);
    } else {
        write_color(images.image.at(pixel.x, pixel.y), value);
    }
    if (layout_.coverage) images.coverage[index(pixel)] = coverage;
}

void Film::set_pixel(const Pass& pass, const Pixel& pixel, const imaging::SignedSums<Terms>& sums,
                     const imaging::CoveredCounts& covered) {
    show(pixel, imaging::pixel_value(sums), imaging::pixel_coverage(covered, sums.count, sums.positives),
         images_of(pass));
}

void Film::commit_preview(const Pass& pass, const FilmTile& values) { write(values, images_of(pass)); }

void Film::show_preview(const Pass& pass, parallel::TaskPool& pool) {
    if (pass.step == 1) return;
    fit(images_);
    const bool smooth = is_light(layout_.show) && !layout_.terms;
    const auto spread = [&](std::span<const float> known, int channels, std::span<float> out) {
        const Layout layout{layout_.area.width, layout_.area.height, channels};
        if (!known.empty()) upsample(known, layout, pass.step, smooth, out, pool);
    };
    spread(preview_.image.pixels, 3, images_.image.pixels);
    for (std::size_t t = 0; t < images_.terms.size(); ++t)
        spread(preview_.terms[t].pixels, 3, images_.terms[t].pixels);
    spread(preview_.coverage, 1, images_.coverage);
}

void Film::move_to(Picture& picture) {
    fit(images_); // black if nothing was measured
    if (!same(layout_.area, layout_.kept)) {
        const Rect &area = layout_.area, &kept = layout_.kept;
        const Rect part{kept.x - area.x, kept.y - area.y, kept.width, kept.height};
        const auto cut_image = [&](Image& image) {
            if (image.pixels.empty()) return;
            cut(image.pixels, {area.width, area.height, 3}, part);
            image.width = part.width;
            image.height = part.height;
        };
        cut_image(images_.image);
        for (Image& term : images_.terms) cut_image(term);
        cut(images_.coverage, {area.width, area.height, 1}, part);
    }
    picture.image = std::move(images_.image);
    picture.terms = std::move(images_.terms);
    picture.coverage = std::move(images_.coverage);
}

// ── Joining ──

void Film::join(const Film& other) {
    if (const char* name = difference(layout_, other.layout_))
        throw Error(ErrorKind::usage, std::string("the films differ in their ") + name);
    if (refined_ != other.refined_)
        throw Error(ErrorKind::usage, "the films differ in the pixels that they refine",
                    "join films before their adaptive samples, or all of the same picture after");
    for (std::size_t tile = 0; tile < samples_.size(); ++tile)
        for (const SampleBlock& a : samples_[tile].blocks)
            for (const SampleBlock& b : other.samples_[tile].blocks)
                if (a.first < b.end() && b.first < a.end())
                    throw Error(ErrorKind::usage, "both films have the same samples",
                                "both have sample " + std::to_string(std::max(a.first, b.first)) +
                                    " of the pixels of tile " + std::to_string(tile));
    fit(images_);
    for (std::size_t tile = 0; tile < samples_.size(); ++tile) {
        const auto& blocks = other.samples_[tile].blocks;
        if (blocks.empty()) continue;
        for (const SampleBlock& block : blocks) insert(samples_[tile], block);
        if (is_complete(other.samples_[tile]))
            copy_pixels(tile, other);
        else
            merge_blocks(tile);
    }
}

void Film::copy_pixels(std::size_t tile, const Film& from) {
    const Rect r = grid_.tile(tile);
    for (int y = r.y; y < r.y + r.height; ++y) {
        const std::size_t floats = 3 * static_cast<std::size_t>(r.width);
        std::copy_n(from.images_.image.at(r.x, y), floats, images_.image.at(r.x, y));
        for (std::size_t t = 0; layout_.terms && t < images_.terms.size(); ++t)
            std::copy_n(from.images_.terms[t].at(r.x, y), floats, images_.terms[t].at(r.x, y));
        if (layout_.coverage)
            std::copy_n(&from.images_.coverage[index({r.x, y})], r.width, &images_.coverage[index({r.x, y})]);
    }
}

template PixelState<Terms> Film::state(std::size_t tile, std::size_t pixel) const;
template PixelState<vec3> Film::state(std::size_t tile, std::size_t pixel) const;

} // namespace glint::rendering
