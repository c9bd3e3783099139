// Explanations of the middle pixel of any scene, in all formats.

#include "fuzz.h"

#include "glint/explain.h"
#include "glint/explanation_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glint;
    return test::accept_or_refuse([&] {
        // What makes explanations long, but not different.
        const LoadOptions options =
            test::without_meshes({"render.size=[8, 8]", "render.spp=1", "whitted.max_depth=3"});
        const LoadedScene loaded = parse_scene(test::text_of(data, size), "fuzz.toml", options);
        const Explanation explanation = explain(test::built(loaded.description), 4, 4);
        explanation_text(explanation);
        explanation_json(explanation);
        explanation_svg(explanation);
    });
}
