// Building a scene with Embree.

#include "embree_scene.h"

#include "rounds.h"

#include <cstring>

namespace glint::bench {

namespace {

RTCDevice new_device(const std::string& isa) {
    const std::string limit = isa.empty() ? "" : ",isa=" + isa;
    return rtcNewDevice(("threads=1,set_affinity=0" + limit).c_str());
}

} // namespace

EmbreeScene::EmbreeScene(const Mesh& mesh, const EmbreeOptions& options) : device_(new_device(options.isa)) {
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
    scene_ = rtcNewScene(device_);
    const RTCBuildQuality quality = options.high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
    rtcSetSceneBuildQuality(scene_, quality);
    rtcSetSceneFlags(scene_, options.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);

    // Embree gets its own copy of the vertices, as it reads beyond the last one.
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(glm::vec3), mesh.positions.size());
    std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(glm::uvec3), mesh.triangles.size());
    rtcSetGeometryBuildQuality(geometry, quality);
    bytes_ = 0;
    const double start = process_seconds();
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    build_seconds_ = process_seconds() - start;
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

bool EmbreeScene::count_bytes(void* self, ssize_t bytes, bool) {
    static_cast<EmbreeScene*>(self)->bytes_ += bytes;
    return true;
}

} // namespace glint::bench
