#pragma once
// Shaders compiled for what a scene needs, buffers, timers.

#include "gpu/records.shared.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint::gpu {

class GpuContext;

/// What is compiled in.
struct ProgramChoice {
    bool glass = false; ///< is anything transparent?
    bool instances = false;
    bool contacts = false;  ///< do surfaces of objects coincide?
    bool terms = false;     ///< sum the terms of the light separately
    bool first_hit = false; ///< measure first hits instead of light
    bool rays = false;      ///< only trace rays: gpu/rays.h
    bool count = false;     ///< count the steps of walks
    int stack = 8;          ///< entries of a walk through the tree

    friend auto operator<=>(const ProgramChoice&, const ProgramChoice&) = default;
};

struct GpuSceneData;

/// What the scene decides; the rest is the caller's choice.
ProgramChoice program_for(const GpuSceneData& scene);

/// The shader's complete text.
std::string shader_source(const ProgramChoice& choice);
/// That of the shader that turns films into pictures.
std::string show_source();

/// A driver's log with names in place of numbers of files: "shading/whitted.shared.h:12: …".
std::string readable_log(const std::string& text);

/// A buffer in the device's memory.
class GpuBuffer {
  public:
    /// Throws Error(device) with the sizes if it is larger than the device's buffers can be; `name` says what
    /// it holds: "the scene's triangles". Without data it is filled with zeros. Never empty: shaders may read
    /// its first bytes.
    GpuBuffer(const GpuContext& context, const char* name, const void* data, std::size_t bytes);
    ~GpuBuffer();
    GpuBuffer(const GpuBuffer&) = delete;
    GpuBuffer& operator=(const GpuBuffer&) = delete;

    std::uint32_t id() const { return id_; }
    std::size_t bytes() const { return bytes_; }
    void bind_storage(std::uint32_t binding) const;
    void bind_uniform(std::uint32_t binding) const;
    void clear(std::size_t bytes) const; ///< zeroes its first bytes, a multiple of 4
    void write(std::size_t offset, const void* data, std::size_t bytes) const;
    void read(std::size_t offset, void* data, std::size_t bytes) const;

  private:
    const GpuContext& context_;
    std::uint32_t id_ = 0;
    std::size_t bytes_ = 0;
};

/// A compiled program, with its uniform block. Like buffers and timers it is used and destroyed while its
/// context is current; otherwise its object stays in the context.
class GpuProgram {
  public:
    static constexpr std::uint32_t group_size = 64; ///< invocations of a work group

    /// Throws Error(device) with the driver's log if it rejects the source.
    GpuProgram(const GpuContext& context, const std::string& source);
    ~GpuProgram();
    GpuProgram(const GpuProgram&) = delete;
    GpuProgram& operator=(const GpuProgram&) = delete;

    /// Starts at least as many invocations. Buffers are bound before.
    void dispatch(const GpuSettings& settings, std::size_t invocations) const;

  private:
    const GpuContext& context_;
    GpuBuffer settings_;
    std::uint32_t id_ = 0;
};

/// Measures how long the device works: by its own clock, or by wall time if the device is the CPU, whose
/// drivers have no clock for compute shaders.
class GpuTimer {
  public:
    explicit GpuTimer(const GpuContext& context);
    ~GpuTimer();
    GpuTimer(const GpuTimer&) = delete;
    GpuTimer& operator=(const GpuTimer&) = delete;

    void start();
    void stop();
    double seconds() const; ///< between the two; waits for the device

  private:
    const GpuContext& context_;
    const bool own_clock_;
    std::uint32_t id_ = 0;
    double wall_ = 0;
};

} // namespace glint::gpu
