#include "formats/ply_mesh.h"
#include "formats/read_bytes.h"
#include "glint/formats.h"

namespace glint {

LoadedMesh load_mesh(const std::string& path, const LoadOptions& options) {
    return parse_ply(read_bytes(path, LoadWatch(path, options)), path, options);
}

LoadedMesh parse_ply(std::span<const std::byte> bytes, const std::string& name, const LoadOptions& options) {
    const LoadWatch watch(name, options);
    const ply::Source source(bytes, name);
    const ply::Header header = ply::parse_header(source);
    const ply::Layout layout = ply::understand(source, header);
    return ply::assemble(source, header, layout, ply::read_body(source, header, layout, watch), watch);
}

} // namespace glint
