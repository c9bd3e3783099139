#pragma once
// A mesh in Embree, built on one thread. Owns device and scene.

#include "glint/scene.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace glint::bench {

struct EmbreeOptions {
    bool high = true; ///< build quality: HIGH, otherwise MEDIUM
    bool robust = false;
    std::string isa; ///< maximum instruction set, such as "avx2"; empty: no limit
};

class EmbreeScene {
  public:
    /// Builds immediately. `mesh` must outlive the scene.
    EmbreeScene(const Mesh& mesh, const EmbreeOptions& options);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene handle() const { return scene_; }
    /// Memory of the BVH as reported by Embree, without vertices.
    std::int64_t bytes() const { return bytes_; }
    /// CPU seconds of the build, vertices and device aside.
    double build_seconds() const { return build_seconds_; }

  private:
    static bool count_bytes(void* self, ssize_t bytes, bool post);

    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::atomic<std::int64_t> bytes_{0};
    double build_seconds_ = 0;
};

} // namespace glint::bench
