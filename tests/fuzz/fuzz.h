#pragma once
// What the targets for libFuzzer share.

#include "glint/error.h"
#include "glint/scene.h"
#include "glint/scene_files.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace glint::test {

/// Calls `read`, which may throw Error(input), or Error(resource) beyond a limit, and nothing else.
template <class Read>
int accept_or_refuse(const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input && error.kind() != ErrorKind::resource) std::abort();
    }
    return 0;
}

/// For a scene alone: meshes are not read.
inline LoadOptions without_meshes(std::vector<Override> overrides = {}) {
    LoadOptions options;
    options.overrides = std::move(overrides);
    options.load_meshes = false;
    return options;
}

/// Builds on the calling thread.
inline Scene built(const SceneDescription& scene) {
    BuildSceneOptions options;
    options.threads = 1;
    return build_scene(scene, options);
}

inline std::span<const std::byte> bytes_of(const std::uint8_t* data, std::size_t size) {
    return std::as_bytes(std::span(data, size));
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

} // namespace glint::test

/// What libFuzzer calls with each input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
