#include "formats/ply_mesh.h"
#include "formats/ply_plain.h"
#include "formats/read_bytes.h"
#include "glint/formats.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

namespace glint {
namespace {

/// Reads a usual file part by part, so that its bytes never leave the cache; nothing where anything is
/// unusual.
std::optional<LoadedMesh> load_plain(InputFile& file, const std::string& path, const LoadWatch& watch) {
    if (!file.size()) return {};
    constexpr std::size_t part = 1U << 18U;
    std::vector<std::byte> bytes(std::min(part, *file.size() + 1));
    std::size_t held = file.read(bytes);

    const std::span<const std::byte> first_part(bytes.data(), held);
    const ply::Source source(first_part, path);
    std::optional<ply::Header> header;
    std::optional<ply::Layout> layout;
    try {
        header = ply::parse_header(source);
        layout = ply::understand(source, *header);
    } catch (const Error&) {
        return {}; // perhaps the header goes on: who sees all of the file says what is wrong
    }
    auto body = ply::PlainBody::begin(*header, *layout, *file.size());
    if (!body) return {};

    std::size_t passed = header->body; // of the bytes held
    std::size_t done = passed;
    while (true) {
        watch.at(done, *file.size());
        const auto taken = body->take(std::span(bytes).subspan(passed, held - passed));
        if (!taken) return {};
        if (body->complete()) break;
        passed += *taken;
        done += *taken;
        std::memmove(bytes.data(), bytes.data() + passed, held - passed);
        held -= passed;
        passed = 0;
        const std::size_t more = file.read(std::span(bytes).subspan(held));
        if (more == 0) return {};
        held += more;
    }
    return ply::assemble(source, *header, *layout, body->finish(), watch);
}

} // namespace

LoadedMesh load_mesh(const std::string& path, const LoadOptions& options) {
    const LoadWatch watch(path, options);
    InputFile file(path);
    if (auto loaded = load_plain(file, path, watch)) return *std::move(loaded);
    if (file.size()) file.rewind();
    return parse_ply(read_bytes(file, watch), path, options);
}

LoadedMesh parse_ply(std::span<const std::byte> bytes, const std::string& name, const LoadOptions& options) {
    const LoadWatch watch(name, options);
    const ply::Source source(bytes, name);
    const ply::Header header = ply::parse_header(source);
    const ply::Layout layout = ply::understand(source, header);
    return ply::assemble(source, header, layout, ply::read_body(source, header, layout, watch), watch);
}

} // namespace glint
