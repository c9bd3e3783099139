// Reading PLY files: fixed-size rows in chunks if possible, otherwise the whole file with full diagnostics.

#include "formats/ply/fixed_rows.h"
#include "formats/ply/mesh.h"
#include "formats/read_bytes.h"
#include "glint/limits.h"
#include "glint/mesh_files.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

namespace glint {

namespace ply = formats::ply;

using formats::LoadWatch;

namespace {

/// Reads a file of fixed-size rows in chunks that fit the cache. Returns nothing if anything is unusual.
std::optional<LoadedMesh> load_fixed_rows(formats::InputFile& file, const std::string& path,
                                          const LoadWatch& watch) {
    if (!file.size()) return {};
    constexpr std::size_t part = 1U << 18U;
    std::vector<std::byte> bytes(std::min(part, *file.size() + 1));
    std::size_t held = file.read(bytes);

    const std::span<const std::byte> first_part(bytes.data(), held);
    const ply::Source source(first_part, path);
    std::optional<ply::Header> header;
    std::optional<ply::MeshLayout> layout;
    try {
        header = ply::parse_header(source);
        layout = ply::interpret_header(source, *header);
    } catch (const Error&) {
        return {}; // the header may continue beyond this chunk; reading the whole file reports the actual
                   // error
    }
    auto reader = ply::FixedRowReader::begin(*header, *layout, *file.size());
    if (!reader) return {};

    std::size_t passed = header->body; // of the bytes in the buffer
    std::size_t done = passed;
    while (true) {
        watch.at(done, *file.size());
        const auto taken = reader->take(std::span(bytes).subspan(passed, held - passed));
        if (!taken) return {};
        if (reader->complete()) break;
        passed += *taken;
        done += *taken;
        std::memmove(bytes.data(), bytes.data() + passed, held - passed);
        held -= passed;
        passed = 0;
        const std::size_t more = file.read(std::span(bytes).subspan(held));
        if (more == 0) return {};
        held += more;
    }
    return ply::assemble(source, *header, *layout, reader->finish(), watch);
}

} // namespace

LoadedMesh load_mesh(const std::string& path, const LoadOptions& options) {
    const LoadWatch watch(path, options);
    formats::InputFile file(path);
    if (file.size())
        require_memory(static_cast<double>(*file.size()), "the mesh", "close other programs", {.file = path});
    if (auto loaded = load_fixed_rows(file, path, watch)) return *std::move(loaded);
    if (file.size()) file.rewind();
    return parse_ply(formats::read_bytes(file, watch), path, options);
}

LoadedMesh parse_ply(std::span<const std::byte> bytes, const std::string& name, const LoadOptions& options) {
    const LoadWatch watch(name, options);
    const ply::Source source(bytes, name);
    formats::refuse_compressed(source.text(), name);
    const ply::Header header = ply::parse_header(source);
    const ply::MeshLayout layout = ply::interpret_header(source, header);
    ply::Rows rows = ply::read_rows(source, header, layout, watch);
    // Bounds in single precision give an origin that is nearer, but not always near.
    dvec3 step(0);
    for (int i = 0; i < 3 && (step = ply::origin_step(rows)) != dvec3(0); ++i)
        rows = ply::read_rows(source, header, layout, watch, rows.mesh.origin + step);
    return ply::assemble(source, header, layout, std::move(rows), watch);
}

} // namespace glint
