#pragma once
// A mesh in Embree, on one thread. Owns device and scene.

#include "glint/scene.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace glint::bench {

struct EmbreeOptions {
    bool high = true; ///< the quality: HIGH or MEDIUM
    bool robust = false;
    std::string isa; ///< the most to use, as "avx2"; empty: all that the machine has
};

class EmbreeScene {
  public:
    /// Builds at once. `mesh` must outlive it.
    EmbreeScene(const Mesh& mesh, const EmbreeOptions& options);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene handle() const { return scene_; }
    /// What Embree itself says that its trees hold, vertices aside.
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
