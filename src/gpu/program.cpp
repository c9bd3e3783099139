#include "gpu/program.h"

#include "gpu/context.h"
#include "gpu/scene_data.h"
#include "gpu/shader_text.h"
#include "render/schedule.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <epoxy/gl.h>
#include <functional>

namespace glint::gpu {
namespace {

constexpr std::size_t min_bytes = 256;

std::string define(const char* name, int value) {
    return "#define " + std::string(name) + " " + std::to_string(value) + "\n";
}

std::size_t digits_from(const std::string& text, std::size_t at) {
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0) ++at;
    return at;
}

/// "7:12(3): error", "7(12) : error" or "ERROR: 7:12: error": file 7 by name.
std::string readable_line(const std::string& line) {
    std::size_t begin = line.find_first_of("0123456789");
    if (begin > 10) return line; // or there is none
    const std::size_t end = digits_from(line, begin);
    if (end == line.size() || (line[end] != ':' && line[end] != '(') || end - begin > 3) return line;
    const std::size_t number_end = digits_from(line, end + 1);
    const auto file = static_cast<std::size_t>(std::stoi(line.substr(begin, end - begin)));
    std::size_t files = 0;
    while (shader_files[files].path != nullptr) ++files;
    if (number_end == end + 1 || file == 0 || file > files) return line;
    return line.substr(0, begin) + shader_files[file - 1].path + ":" +
           line.substr(end + 1, number_end - end - 1) + line.substr(number_end + (line[end] == '(' ? 1 : 0));
}

template <class Query, class Get>
std::string log_of(GLuint id, Query query, Get get) {
    GLint length = 0;
    query(id, GL_INFO_LOG_LENGTH, &length);
    std::string info_log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get(id, length, nullptr, info_log.data());
    info_log.resize(std::min(info_log.size(), info_log.find('\0')));
    return readable_log(info_log);
}

/// The files that are `wanted`, with directives that number their lines.
std::string joined(const std::string& defines, const std::function<bool(const std::string&)>& wanted) {
    std::string source = "#version 430 core\n" + define("GLINT_GLSL", 1) + defines;
    for (int i = 0; shader_files[i].path != nullptr; ++i)
        if (wanted(shader_files[i].path))
            source += "#line 1 " + std::to_string(i + 1) + "\n" + shader_files[i].text + "\n";
    return source;
}

/// Is a file part of a program that traces rays? Most are part of all.
bool is_part(const std::string& path, const ProgramChoice& choice) {
    if (path == "gpu/shaders/show.glsl") return false;
    if (path == "gpu/shaders/rays.glsl") return choice.rays;
    if (path == "gpu/shaders/loop.glsl" || path == "gpu/shaders/lights.glsl") return !choice.rays;
    if (path == "gpu/shaders/first_hit.glsl") return !choice.rays && choice.first_hit;
    if (path == "gpu/shaders/whitted.glsl") return !choice.rays && !choice.first_hit;
    return true;
}

[[noreturn]] void refuse(const GpuContext& context, const std::string& info_log) {
    throw Error(ErrorKind::device,
                "the driver of " + context.device().name + " refuses the shader:\n" + info_log,
                "this is a defect of glint or of the driver: please report it; --backend cpu needs neither");
}

} // namespace

ProgramChoice program_for(const GpuSceneData& scene) {
    ProgramChoice choice;
    choice.glass = scene.glass;
    choice.contacts = scene.contacts;
    choice.instances = !scene.tree.mesh_roots.empty();
    // Few sizes, since drivers take long to compile.
    choice.stack = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(scene.tree.stack, 16))));
    return choice;
}

std::string shader_source(const ProgramChoice& choice) {
    return joined(
        define("GLINT_GLASS", choice.glass ? 1 : 0) + define("GLINT_INSTANCES", choice.instances ? 1 : 0) +
            define("GLINT_CONTACTS", choice.contacts ? 1 : 0) + define("GLINT_TERMS", choice.terms ? 7 : 1) +
            define("GLINT_COUNT", choice.first_hit || choice.count ? 1 : 0) +
            define("GLINT_STACK", choice.stack),
        [&](const std::string& path) { return is_part(path, choice); });
}

std::string show_source() {
    static const char* const needed[] = {
        "math/shared.h",        "imaging/filter.shared.h", "shading/records.shared.h",
        "gpu/records.shared.h", "gpu/shaders/data.glsl",   "gpu/shaders/slot_fields.glsl",
        "gpu/shaders/show.glsl"};
    return joined("", [](const std::string& path) {
        return std::find(std::begin(needed), std::end(needed), path) != std::end(needed);
    });
}

std::string readable_log(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        out += readable_line(text.substr(at, end - at)) + "\n";
        at = end + 1;
    }
    return out;
}

GpuProgram::GpuProgram(const GpuContext& context, const std::string& source)
    : context_(context), settings_(context, "the settings", nullptr, sizeof(GpuSettings)) {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_FALSE) {
        const std::string info_log = log_of(shader, glGetShaderiv, glGetShaderInfoLog);
        glDeleteShader(shader);
        refuse(context, info_log);
    }
    id_ = glCreateProgram();
    glAttachShader(id_, shader);
    glLinkProgram(id_);
    glDeleteShader(shader);
    glGetProgramiv(id_, GL_LINK_STATUS, &done);
    if (done == GL_FALSE) {
        const std::string info_log = log_of(id_, glGetProgramiv, glGetProgramInfoLog);
        glDeleteProgram(id_);
        refuse(context, info_log);
    }
}

GpuProgram::~GpuProgram() {
    if (context_.is_current()) glDeleteProgram(id_);
}

void GpuProgram::dispatch(const GpuSettings& settings, std::size_t invocations) const {
    glUseProgram(id_);
    settings_.write(0, &settings, sizeof settings);
    settings_.bind_uniform(0);
    glDispatchCompute(static_cast<GLuint>((invocations + group_size - 1) / group_size), 1, 1);
}

GpuBuffer::GpuBuffer(const GpuContext& context, const char* name, const void* data, std::size_t bytes)
    : context_(context), bytes_(std::max(bytes, min_bytes)) {
    const std::uint64_t most = context.device().max_buffer;
    if (bytes > most)
        throw Error(ErrorKind::device,
                    std::string(name) + " take " + std::to_string(bytes) + " bytes, and a buffer of " +
                        context.device().name + " holds " + std::to_string(most),
                    "render on the CPU");
    glGenBuffers(1, &id_);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes_), nullptr, GL_DYNAMIC_COPY);
    try {
        context.check("taking " + std::to_string(bytes_) + " bytes for " + name);
    } catch (...) {
        glDeleteBuffers(1, &id_);
        throw;
    }
    if (data == nullptr || bytes < bytes_) clear(bytes_);
    if (data != nullptr && bytes > 0) write(0, data, bytes);
}

GpuBuffer::~GpuBuffer() {
    if (context_.is_current()) glDeleteBuffers(1, &id_);
}

void GpuBuffer::bind_storage(std::uint32_t binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id_);
}

void GpuBuffer::bind_uniform(std::uint32_t binding) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, id_);
}

void GpuBuffer::clear(std::size_t bytes) const {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
    glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, static_cast<GLsizeiptr>(bytes),
                         GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void GpuBuffer::write(std::size_t offset, const void* data, std::size_t bytes) const {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                    data);
}

void GpuBuffer::read(std::size_t offset, void* data, std::size_t bytes) const {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                       static_cast<GLsizeiptr>(bytes), data);
}

GpuTimer::GpuTimer(const GpuContext& context) : context_(context), own_clock_(!context.device().software) {
    glGenQueries(1, &id_);
}

GpuTimer::~GpuTimer() {
    if (context_.is_current()) glDeleteQueries(1, &id_);
}

void GpuTimer::start() {
    wall_ = -rendering::wall_seconds();
    if (own_clock_) glBeginQuery(GL_TIME_ELAPSED, id_);
}

void GpuTimer::stop() {
    if (own_clock_) return glEndQuery(GL_TIME_ELAPSED);
    glFinish();
    wall_ += rendering::wall_seconds();
}

double GpuTimer::seconds() const {
    if (!own_clock_) return wall_;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(id_, GL_QUERY_RESULT, &nanoseconds);
    return 1e-9 * static_cast<double>(nanoseconds);
}

} // namespace glint::gpu
