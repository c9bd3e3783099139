#include "gpu/scene_buffers.h"

#include "gpu/context.h"

namespace glint::gpu {
namespace {

template <class T>
std::size_t size_of(const std::vector<T>& elements) {
    return elements.size() * sizeof(T);
}

template <class T>
std::shared_ptr<const GpuBuffer> shared(const GpuContext& context, const char* name,
                                        const std::vector<T>& elements) {
    return std::make_shared<GpuBuffer>(context, name, elements.data(), size_of(elements));
}

} // namespace

SceneBuffers::SceneBuffers(const GpuContext& c, const GpuSceneData& d, const SceneBuffers* before)
    : nodes_(before != nullptr ? before->nodes_ : shared(c, "the tree's nodes", d.tree.nodes)),
      leaves_(before != nullptr ? before->leaves_ : shared(c, "the scene's triangles", d.tree.leaves)),
      objects_(c, "the scene's objects", d.objects.data(), size_of(d.objects)),
      words_(c, "the meshes' normals and colours", d.words.data(), size_of(d.words)),
      lights_(c, "the scene's lights", nullptr, sizeof(FilterTable) + size_of(d.lights)),
      shapes_(c, "the scene's planes and quadrics", d.shapes.data(), size_of(d.shapes)) {
    lights_.write(0, &d.filter_table, sizeof(FilterTable));
    if (!d.lights.empty()) lights_.write(sizeof(FilterTable), d.lights.data(), size_of(d.lights));
}

void SceneBuffers::bind() const {
    std::uint32_t binding = 0;
    for (const GpuBuffer* buffer : {nodes_.get(), leaves_.get(), &objects_, &words_, &lights_, &shapes_})
        buffer->bind_storage(binding++);
}

} // namespace glint::gpu
