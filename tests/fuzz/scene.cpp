// Scene files: reading, building, and writing what was read.

#include "fuzz.h"

#include "glint/document.h"
#include "glint/scene.h"
#include "glint/scene_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glint;
    return test::accept_or_refuse([&] {
        const LoadOptions options = {.load_meshes = false};
        const SceneDescription scene =
            parse_scene(test::text_of(data, size), "fuzz.toml", options).description;
        parse_scene(scene_text(scene), "written.toml", options);
        build_scene(scene, {.threads = 1});
    });
}
