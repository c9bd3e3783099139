// Scene files: reading, building, and writing what was read.

#include "fuzz.h"

#include "glint/document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glint;
    return test::accept_or_refuse([&] {
        const SceneDescription scene =
            parse_scene(test::text_of(data, size), "fuzz.toml", test::without_meshes()).description;
        parse_scene(scene_text(scene), "written.toml", test::without_meshes());
        test::built(scene);
    });
}
