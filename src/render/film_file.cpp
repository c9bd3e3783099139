// A film as bytes: a header, the blocks of samples of each tile with their sums, and a check sum, in the byte
// order of the machine. A film of another byte order is refused like one of another version.

#include "render/film.h"

#include "glint/error.h"
#include "glint/limits.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace glint::rendering {
namespace {

constexpr std::uint64_t magic = 0x6d6c6966'746e6c67; ///< "glntfilm"
constexpr std::uint32_t version_of_format = 3;

/// FNV-1a over words of 8 bytes (Fowler, Noll and Vo).
std::uint64_t check_sum(std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (std::size_t at = 0; at < bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, &bytes[at], std::min<std::size_t>(8, bytes.size() - at));
        hash = (hash ^ word) * 0x100000001b3;
        hash ^= hash >> 32;
    }
    return hash;
}

void append(std::vector<std::byte>& out, const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::byte*>(data);
    out.insert(out.end(), bytes, bytes + size);
}

template <class T>
void append(std::vector<std::byte>& out, const T& value) {
    append(out, &value, sizeof value);
}

struct Header {
    std::uint64_t magic = glint::rendering::magic;
    std::uint32_t version = version_of_format;
    std::int32_t x = 0, y = 0, width = 0, height = 0;
    std::int32_t tile_size = 0, samples = 0, samples_of_differing = 0;
    std::int32_t kept_x = 0, kept_y = 0, kept_width = 0, kept_height = 0;
    std::int32_t term = -1;
    std::uint32_t keeps = 0;   ///< 1: terms, 2: coverage
    std::uint32_t show = 0;    ///< Aov
    std::uint32_t refined = 0; ///< 1: by pixel, whether it is refined follows
};
static_assert(sizeof(Header) == 72);

[[noreturn]] void refuse(const char* why) {
    throw Error(ErrorKind::input, std::string("the film cannot be read: ") + why);
}

FilmLayout layout_of(const Header& h) {
    const auto is_side = [](std::int32_t n) { return n >= 1 && n <= picture_side_limit; };
    const auto holds = [](std::int32_t first, std::int32_t size, std::int32_t from, std::int32_t length) {
        return from >= first && length >= 1 && length <= size && from - first <= size - length;
    };
    const bool is_sound =
        is_side(h.width) && is_side(h.height) && h.x >= 0 && h.y >= 0 &&
        std::int64_t{h.width} * h.height <= picture_pixel_limit && is_side(h.tile_size) && h.samples >= 1 &&
        h.samples <= sample_limit && h.term >= -1 && h.term < term_count && h.keeps <= 3 &&
        h.show < aov_count && holds(h.x, h.width, h.kept_x, h.kept_width) &&
        holds(h.y, h.height, h.kept_y, h.kept_height) &&
        (h.samples_of_differing == 0 || h.samples_of_differing > h.samples) &&
        h.samples_of_differing <= sample_limit && h.refined <= (h.samples_of_differing > 0 ? 1U : 0U);
    if (!is_sound) refuse("its header is damaged");
    FilmLayout layout;
    layout.area = {h.x, h.y, h.width, h.height};
    layout.kept = {h.kept_x, h.kept_y, h.kept_width, h.kept_height};
    layout.tile_size = h.tile_size;
    layout.samples = {h.samples, h.samples_of_differing};
    layout.show = static_cast<Aov>(h.show);
    if (h.term >= 0) layout.term = h.term;
    layout.terms = (h.keeps & 1U) != 0;
    layout.coverage = (h.keeps & 2U) != 0;
    return layout;
}

} // namespace

class FilmReader {
  public:
    explicit FilmReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::size_t left() const { return bytes_.size(); }
    void read(void* to, std::size_t size) {
        if (size > bytes_.size()) refuse("it ends too early");
        std::memcpy(to, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }
    template <class T>
    T value() {
        T v;
        read(&v, sizeof v);
        return v;
    }

  private:
    std::span<const std::byte> bytes_;
};

std::vector<std::byte> Film::save() const {
    Header header;
    header.x = layout_.area.x;
    header.y = layout_.area.y;
    header.width = layout_.area.width;
    header.height = layout_.area.height;
    header.kept_x = layout_.kept.x;
    header.kept_y = layout_.kept.y;
    header.kept_width = layout_.kept.width;
    header.kept_height = layout_.kept.height;
    header.tile_size = layout_.tile_size;
    header.samples = layout_.samples.all;
    header.samples_of_differing = layout_.samples.differing;
    header.refined = is_refined() ? 1 : 0;
    header.term = layout_.term.value_or(-1);
    header.show = static_cast<std::uint32_t>(layout_.show);
    header.keeps = (layout_.terms ? 1U : 0U) | (layout_.coverage ? 2U : 0U);
    std::vector<std::byte> out;
    append(out, header);
    append(out, refined_.data(), refined_.size());
    for (std::size_t tile = 0; tile < samples_.size(); ++tile) save_tile(tile, out);
    append(out, check_sum(out));
    return out;
}

Film Film::load(std::span<const std::byte> bytes) {
    FilmReader in(bytes);
    const auto header = in.value<Header>();
    if (header.magic != magic) refuse("it is not a film of glint");
    if (header.version != version_of_format) refuse("it is of another version of glint");
    const auto sum_at = bytes.size() - sizeof(std::uint64_t);
    if (FilmReader(bytes.subspan(sum_at)).value<std::uint64_t>() != check_sum(bytes.first(sum_at)))
        refuse("it is damaged");
    // Allocate for the bytes that there are, not for what the header claims.
    const FilmLayout layout = layout_of(header);
    const TileGrid grid(layout.area.width, layout.area.height, layout.tile_size);
    if (grid.count() > in.left() / sizeof(std::uint32_t)) refuse("it ends too early");
    Film film(layout);
    if (header.refined != 0) {
        const std::size_t pixels = film.index({0, layout.area.height});
        if (pixels > in.left()) refuse("it ends too early");
        film.refined_.resize(pixels);
        in.read(film.refined_.data(), pixels);
    }
    for (std::size_t tile = 0; tile < film.samples_.size(); ++tile) film.load_tile(tile, in);
    if (in.left() != sizeof(std::uint64_t)) refuse("it is too long");
    return film;
}

template <class AnyFilm, class F>
void Film::for_rows(AnyFilm& film, std::size_t tile, const F& f) {
    const Rect r = film.grid_.tile(tile);
    const auto width = static_cast<std::size_t>(r.width);
    for (int y = r.y; y < r.y + r.height; ++y) {
        f(std::span(film.images_.image.at(r.x, y), 3 * width));
        for (auto& term : film.images_.terms)
            if (film.layout_.terms) f(std::span(term.at(r.x, y), 3 * width));
        if (film.layout_.coverage) f(std::span(&film.images_.coverage[film.index({r.x, y})], width));
    }
}

void Film::save_tile(std::size_t tile, std::vector<std::byte>& out) const {
    const TileSamples& samples = samples_[tile];
    append(out, static_cast<std::uint32_t>(samples.blocks.size()));
    for (const SampleBlock& block : samples.blocks) {
        append(out, block.first);
        append(out, block.count);
        if (!is_complete(samples)) append(out, block.states.data(), state_bytes(tile));
    }
    if (samples.blocks.empty() && !is_refined()) return;
    for_rows(*this, tile, [&](std::span<const float> row) { append(out, row.data(), row.size_bytes()); });
}

void Film::load_tile(std::size_t tile, FilmReader& in) {
    TileSamples& samples = samples_[tile];
    const auto blocks = in.value<std::uint32_t>();
    if (blocks > static_cast<std::uint32_t>(this->samples())) refuse("its tiles are damaged");
    for (std::uint32_t i = 0; i < blocks; ++i) {
        SampleBlock& block = samples.blocks.emplace_back();
        block.first = in.value<int>();
        block.count = in.value<int>();
        if (i == 0 && is_complete(samples)) continue;
        if (state_bytes(tile) > in.left()) refuse("it ends too early");
        block.states.resize(state_bytes(tile));
        in.read(block.states.data(), block.states.size());
    }
    if (!is_sound(samples)) refuse("its samples are damaged");
    if (blocks == 0 && !is_refined()) return;
    if (3 * sizeof(float) * pixels_of(tile) > in.left()) refuse("it ends too early");
    fit(images_);
    for_rows(*this, tile, [&](std::span<float> row) { in.read(row.data(), row.size_bytes()); });
}

/// True if its blocks are such as merge_blocks() leaves.
bool Film::is_sound(const TileSamples& tile) const {
    int end = 0;
    for (const SampleBlock& block : tile.blocks) {
        if (block.first < end || block.count < 1 || block.count > samples() - block.first) return false;
        end = block.end();
        const auto tree = static_cast<int>(std::bit_ceil(static_cast<unsigned>(block.count)));
        if (block.first % tree != 0 || (block.count != tree && end != samples())) return false;
    }
    return true;
}

} // namespace glint::rendering
