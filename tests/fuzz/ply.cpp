// PLY meshes.

#include "fuzz.h"

#include "glint/mesh_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glint;
    return test::accept_or_refuse([&] { parse_ply(test::bytes_of(data, size), "fuzz.ply"); });
}
