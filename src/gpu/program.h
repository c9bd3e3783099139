#pragma once
// The shader, compiled for what a scene needs, and buffers.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glint {

class GpuContext;

/// What is compiled in.
struct ProgramChoice {
    bool glass = false; ///< does anything let light through?
    bool instances = false;
    bool terms = false;     ///< keep the terms of the light apart
    bool first_hit = false; ///< show numbers of first hits in place of the light
    bool rays = false;      ///< trace rays alone: gpu/rays.h
    bool count = false;     ///< count the steps of walks
    int stack = 8;          ///< entries of a walk through the tree

    friend auto operator<=>(const ProgramChoice&, const ProgramChoice&) = default;
};

struct GpuSceneData;

/// What a scene asks for: the rest is the caller's.
ProgramChoice program_for(const GpuSceneData& scene);

/// All of the shader's text, as it is given to the compiler.
std::string shader_source(const ProgramChoice& choice);
/// The text of the shader that makes pictures of films.
std::string show_source();

/// A driver's log with numbers of files replaced by their names: "shading/whitted.shared.h:12: …".
std::string readable_log(const std::string& text);

/// A compiled program. Like buffers and timers it needs its context to be current wherever it is used, and
/// stays in it where it ends while that is not so.
class GpuProgram {
  public:
    /// Throws Error(device) with the driver's log where it refuses the source.
    GpuProgram(const GpuContext& context, const std::string& source);
    ~GpuProgram();
    GpuProgram(const GpuProgram&) = delete;
    GpuProgram& operator=(const GpuProgram&) = delete;

    void use() const;

  private:
    const GpuContext& context_;
    std::uint32_t id_ = 0;
};

/// A buffer in the device's memory.
class GpuBuffer {
  public:
    /// Throws Error(device) where it is larger than the device's buffers can be, with the sizes; `name` says
    /// what it holds: "the scene's triangles". Without data it is filled with zeros. Never empty: shaders may
    /// read its first bytes.
    GpuBuffer(const GpuContext& context, const char* name, const void* data, std::size_t bytes);
    ~GpuBuffer();
    GpuBuffer(const GpuBuffer&) = delete;
    GpuBuffer& operator=(const GpuBuffer&) = delete;

    std::uint32_t id() const { return id_; }
    std::size_t bytes() const { return bytes_; }
    void bind_storage(std::uint32_t binding) const;
    void bind_uniform(std::uint32_t binding) const;
    void clear() const;                  ///< to zeros
    void clear(std::size_t bytes) const; ///< its first bytes, a multiple of 4
    void write(std::size_t offset, const void* data, std::size_t bytes) const;
    void read(std::size_t offset, void* data, std::size_t bytes) const;

  private:
    const GpuContext& context_;
    std::uint32_t id_ = 0;
    std::size_t bytes_ = 0;
};

/// How long the device works: by its own clock, or where it is the CPU, whose drivers have none that counts
/// compute shaders, by the wall's.
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

} // namespace glint
