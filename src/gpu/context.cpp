#include "gpu/context.h"

#include <algorithm>
#include <array>
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace glint::gpu {

namespace {

/// Is a library installed? libepoxy ends the program if it misses one. The library stays loaded for libepoxy.
bool can_load(const char* library) { return dlopen(library, RTLD_LAZY | RTLD_LOCAL) != nullptr; }

bool has_word(const char* list, const std::string& word) {
    return list != nullptr && (" " + std::string(list) + " ").find(" " + word + " ") != std::string::npos;
}

std::string text(const GLubyte* bytes) {
    return bytes == nullptr ? std::string() : reinterpret_cast<const char*>(bytes);
}

/// A display and a context on it.
struct Opened {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::string fault; ///< why there is no context
};

constexpr int min_major = 4;
constexpr int min_minor = 3;

EGLContext make_context(EGLDisplay display) {
    // A context that reports its loss, if the driver supports that.
    const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           min_major,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           min_minor,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                           EGL_LOSE_CONTEXT_ON_RESET,
                                           EGL_NONE};
    const EGLContext robust = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (robust != EGL_NO_CONTEXT) return robust;
    std::array<EGLint, 9> plain = attributes;
    plain[6] = EGL_NONE;
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, plain.data());
}

Opened open_device(EGLDeviceEXT device) {
    Opened opened;
    opened.display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (opened.display == EGL_NO_DISPLAY || eglInitialize(opened.display, nullptr, nullptr) == EGL_FALSE) {
        opened.fault = "EGL cannot open it; /dev/dri may not be readable";
        return opened;
    }
    const char* extensions = eglQueryString(opened.display, EGL_EXTENSIONS);
    if (!has_word(extensions, "EGL_KHR_surfaceless_context") ||
        !has_word(extensions, "EGL_KHR_no_config_context")) {
        opened.fault = "its driver knows no contexts without a surface";
        return opened;
    }
    eglBindAPI(EGL_OPENGL_API);
    opened.context = make_context(opened.display);
    if (opened.context == EGL_NO_CONTEXT ||
        eglMakeCurrent(opened.display, EGL_NO_SURFACE, EGL_NO_SURFACE, opened.context) == EGL_FALSE) {
        opened.fault = "it has no OpenGL 4.3, which compute shaders need";
    }
    return opened;
}

void close(Opened& opened) {
    if (opened.display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(opened.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (opened.context != EGL_NO_CONTEXT) eglDestroyContext(opened.display, opened.context);
    opened.context = EGL_NO_CONTEXT;
}

std::uint64_t limit(GLenum name) {
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return static_cast<std::uint64_t>(std::max<GLint64>(value, 0));
}

constexpr std::uint64_t buffers_needed = 8;

/// Describes the device of the current context.
void describe_current(GpuDevice& d) {
    d.name = text(glGetString(GL_RENDERER));
    d.driver = text(glGetString(GL_VENDOR)) + ", OpenGL " + text(glGetString(GL_VERSION));
    if (epoxy_gl_version() < 10 * min_major + min_minor) return;
    d.max_buffer = limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    d.buffers = limit(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
    d.max_group = limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS);
    if (d.buffers < buffers_needed)
        d.fault = "its shaders see " + std::to_string(d.buffers) + " buffers, and glint's need " +
                  std::to_string(buffers_needed);
}

GpuDevice describe(const Opened& opened, EGLDeviceEXT device) {
    GpuDevice d;
    d.software = has_word(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    d.name = d.software ? "software" : "graphics card";
    d.fault = opened.fault;
    if (d.fault.empty()) describe_current(d);
    return d;
}

/// The devices that EGL lists; if there are none, `why` says what is missing.
std::vector<EGLDeviceEXT> list_devices(std::string& why) {
    if (!can_load("libEGL.so.1")) {
        why = "libEGL.so.1 is not installed (Debian: apt-get install libegl1)";
        return {};
    }
    if (!can_load("libOpenGL.so.0") && !can_load("libGL.so.1")) {
        why = "libOpenGL.so.0 is not installed (Debian: apt-get install libopengl0)";
        return {};
    }
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_word(extensions, "EGL_EXT_platform_device") ||
        !(has_word(extensions, "EGL_EXT_device_enumeration") ||
          has_word(extensions, "EGL_EXT_device_base"))) {
        why = "EGL cannot list devices (Debian: apt-get install libgl1-mesa-dri)";
        return {};
    }
    std::array<EGLDeviceEXT, 32> found{};
    EGLint count = 0;
    eglQueryDevicesEXT(static_cast<EGLint>(found.size()), found.data(), &count);
    if (count == 0) why = "EGL knows no device (Debian: apt-get install libgl1-mesa-dri)";
    return std::vector<EGLDeviceEXT>(found.begin(), found.begin() + count);
}

void GLAPIENTRY note_complaint(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                               const void* list) {
    if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
    static_cast<std::vector<std::string>*>(const_cast<void*>(list))->emplace_back(message);
}

} // namespace

struct GpuContext::State {
    Opened opened; ///< no display: the context belongs to the caller
    GpuDevice device;
    std::vector<std::string> complaints;
};

GpuContext::GpuContext(int number) : state_(std::make_unique<State>()) {
    std::string why;
    const std::vector<EGLDeviceEXT> devices = list_devices(why);
    const auto refuse = [](const std::string& what) {
        throw Error(ErrorKind::device, what, "glint info --devices lists devices; --backend cpu needs none");
    };
    if (devices.empty()) refuse("no GPU can be used: " + why);
    if (number >= static_cast<int>(devices.size()))
        refuse("there is no device " + std::to_string(number) + " among " + std::to_string(devices.size()));

    // Hardware first, then software.
    for (const bool software : {false, true}) {
        for (std::size_t i = 0; i < devices.size(); ++i) {
            if (number >= 0 && static_cast<int>(i) != number) continue;
            state_->opened = open_device(devices[i]);
            state_->device = describe(state_->opened, devices[i]);
            why = state_->device.name + ": " + state_->device.fault;
            if (state_->device.fault.empty() && (number >= 0 || state_->device.software == software)) {
                glEnable(GL_DEBUG_OUTPUT);
                glDebugMessageCallback(note_complaint, &state_->complaints);
                leave();
                return;
            }
            close(state_->opened);
        }
    }
    refuse("no GPU can be used: " + why);
}

GpuContext::GpuContext(GpuCurrentContext current) : state_(std::make_unique<State>()) {
    state_->device = gpu_device(current);
    if (!state_->device.fault.empty())
        throw Error(ErrorKind::device, "the GPU cannot be used in the window: " + state_->device.fault,
                    "the CPU needs none of it");
}

GpuContext::~GpuContext() { close(state_->opened); }

const GpuDevice& GpuContext::device() const { return state_->device; }

void GpuContext::set_max_buffer(std::uint64_t bytes) { state_->device.max_buffer = bytes; }

void GpuContext::enter() const {
    if (!try_enter()) throw Error(ErrorKind::device, "the GPU's context cannot be used from this thread");
}

bool GpuContext::try_enter() const noexcept {
    const Opened& opened = state_->opened;
    if (opened.display == EGL_NO_DISPLAY) return true;
    // The bound interface is a state of the thread.
    eglBindAPI(EGL_OPENGL_API);
    return eglMakeCurrent(opened.display, EGL_NO_SURFACE, EGL_NO_SURFACE, opened.context) == EGL_TRUE;
}

void GpuContext::leave() const {
    if (state_->opened.display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(state_->opened.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool GpuContext::is_current() const {
    return state_->opened.display == EGL_NO_DISPLAY || eglGetCurrentContext() == state_->opened.context;
}

void GpuContext::check(const std::string& doing) const {
    const bool tells = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness");
    if (tells && glGetGraphicsResetStatus() != GL_NO_ERROR)
        throw Error(ErrorKind::device, "the GPU was lost while " + doing,
                    "another program or its watchdog may have reset it; try again, or use --backend cpu");
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY)
        throw Error(ErrorKind::device, "the GPU ran out of memory while " + doing,
                    "render on the CPU, or a smaller scene");
    throw Error(ErrorKind::device, "OpenGL error " + std::to_string(error) + " while " + doing,
                state_->complaints.empty() ? "" : state_->complaints.back());
}

const std::vector<std::string>& GpuContext::complaints() const { return state_->complaints; }

} // namespace glint::gpu

namespace glint {

std::vector<GpuDevice> gpu_devices(std::string* why) {
    std::string reason;
    std::vector<GpuDevice> devices;
    for (const EGLDeviceEXT device : gpu::list_devices(reason)) {
        gpu::Opened opened = gpu::open_device(device);
        devices.push_back(gpu::describe(opened, device));
        gpu::close(opened);
    }
    if (why != nullptr) *why = reason;
    return devices;
}

GpuDevice gpu_device(GpuCurrentContext) {
    const std::array<std::string, 3> software{"llvmpipe", "softpipe", "Software Rasterizer"};
    const int version = epoxy_gl_version();
    GpuDevice d;
    gpu::describe_current(d);
    d.software = std::any_of(software.begin(), software.end(),
                             [&](const std::string& name) { return d.name.rfind(name, 0) == 0; });
    if (version < 10 * gpu::min_major + gpu::min_minor)
        d.fault = "it has OpenGL " + std::to_string(version / 10) + "." + std::to_string(version % 10) +
                  ", and compute shaders need 4.3";
    return d;
}

} // namespace glint
