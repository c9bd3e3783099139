// A shared library that uses all of an installed glint: a scene from text, a picture, and a mesh to trace.

#include <glint/formats.h>
#include <glint/render.h>
#include <glint/trace.h>

#include <cstdio>
#include <vector>

/// 0 if glint does what it should.
extern "C" int use_glint() {
    glint::LoadedScene loaded =
        glint::parse_scene(glint::template_text(glint::template_names().front()), "new");
    loaded.description.render.width = 32;
    loaded.description.render.height = 24;
    const glint::Picture picture = glint::render(glint::build_scene(loaded.description));
    std::printf("glint %s rendered %d x %d pixels\n", glint::version(), picture.image.width,
                picture.image.height);

    const std::vector<float> vertices{-1, -1, 2, 1, -1, 2, 0, 1, 2};
    const std::vector<std::uint32_t> triangles{0, 1, 2};
    const glint::tracing::Mesh mesh(vertices, triangles);
    const glint::tracing::Hit hit = mesh.closest(glint::tracing::Ray{});
    std::printf("the ray hits at t = %g\n", static_cast<double>(hit.t));
    return picture.complete && hit.t == 2 ? 0 : 1;
}
