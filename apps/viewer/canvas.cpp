// Textures, the two shaders that draw them, and the sampler.
#include "canvas.h"

#include "glint/error.h"

#include <epoxy/gl.h>

#include <cmath>
#include <string>

namespace glint::viewer {
namespace {

constexpr const char* vertex_source = R"(#version 330 core
uniform vec4 corners; // of the area, in clip space: left, top, right, bottom
out vec2 uv;
void main() {
    uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(corners.xy, corners.zw, uv), 0.0, 1.0);
}
)";

// As simple as possible: software renderers have a fast path for it.
constexpr const char* plain_source = R"(#version 330 core
uniform sampler2D picture;
in vec2 uv;
out vec4 color;
void main() { color = texture(picture, uv); }
)";

// For linear light: the exact sRGB curve, as in files.
constexpr const char* srgb_source = R"(#version 330 core
uniform sampler2D picture;
in vec2 uv;
out vec4 color;
void main() {
    vec3 light = clamp(texture(picture, uv).rgb, 0.0, 1.0);
    vec3 curve = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    color = vec4(mix(light * 12.92, curve, greaterThan(light, vec3(0.0031308))), 1.0);
}
)";

unsigned compile(GLenum kind, const char* source) {
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

unsigned link(const char* fragment_source) {
    const unsigned vertex = compile(GL_VERTEX_SHADER, vertex_source);
    const unsigned fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
    const unsigned program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint good = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return program;
    std::string log(1024, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw Error(ErrorKind::device, "the graphics driver refuses the window's shader: " + log,
                "render to a file instead: glint FILE -o picture.png");
}

} // namespace

Canvas::Program::Program(const char* fragment_source)
    : name(link(fragment_source)), corners(glGetUniformLocation(name, "corners")) {}

Canvas::Canvas() : plain_(plain_source), srgb_(srgb_source) {
    glGenVertexArrays(1, &points_);
    for (Texture& texture : pictures_) glGenTextures(1, &texture.name);
    // A sampler instead of texture parameters: some textures belong to the renderer.
    glGenSamplers(1, &sampler_);
    glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Canvas::~Canvas() {
    for (const Texture& texture : pictures_) glDeleteTextures(1, &texture.name);
    glDeleteSamplers(1, &sampler_);
    glDeleteVertexArrays(1, &points_);
    for (const Program* program : {&plain_, &srgb_}) glDeleteProgram(program->name);
}

void Canvas::upload(ViewSlot slot, int width, int height, const std::vector<std::uint32_t>& pixels) {
    Texture& texture = pictures_[slot];
    texture.on_device.reset();
    glBindTexture(GL_TEXTURE_2D, texture.name);
    // The layout of graphics cards: no conversion.
    constexpr GLenum order = GL_BGRA;
    constexpr GLenum packed = GL_UNSIGNED_INT_8_8_8_8_REV;
    if (texture.width == width && texture.height == height) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, order, packed, pixels.data());
    } else {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, order, packed, pixels.data());
        texture.width = width;
        texture.height = height;
    }
}

void Canvas::show(ViewSlot slot, std::shared_ptr<const GpuPicture> picture) {
    pictures_[slot].on_device = std::move(picture);
}

glm::vec3 Canvas::pixel_of(const GpuPicture& picture, int x, int y) {
    glm::vec3 color(0.0f);
    GLuint target = 0;
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.texture(), 0);
    glReadPixels(x, y, 1, 1, GL_RGB, GL_FLOAT, &color.x);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &target);
    return color;
}

void Canvas::was_drawn() const {
    for (const Texture& texture : pictures_)
        if (texture.on_device) texture.on_device->was_drawn();
}

void Canvas::draw(ViewSlot slot, const Area& area, const Area& part, View view,
                  const WindowSize& window) const {
    const float ratio = window.pixels_per_unit();
    const auto pixels = [ratio](float units) { return static_cast<GLint>(std::lround(units * ratio)); };
    const GLint bottom = window.pixel_height - pixels(part.y + part.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixels(part.x), bottom, pixels(part.x + part.width) - pixels(part.x),
              pixels(part.y + part.height) - pixels(part.y));
    glDisable(GL_BLEND);
    const Texture& texture = pictures_[slot];
    // Pictures on the card are linear light; uploaded ones are in colours of the screen.
    const Program& program = texture.on_device && view == View::srgb ? srgb_ : plain_;
    glUseProgram(program.name);
    const auto clip_x = [&](float x) { return 2 * x / static_cast<float>(window.width) - 1; };
    const auto clip_y = [&](float y) { return 1 - 2 * y / static_cast<float>(window.height); };
    glUniform4f(program.corners, clip_x(area.x), clip_y(area.y), clip_x(area.x + area.width),
                clip_y(area.y + area.height));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.on_device ? texture.on_device->texture() : texture.name);
    glBindSampler(0, sampler_);
    // Magnified pixels keep sharp edges.
    const int width = texture.on_device ? texture.on_device->width() : texture.width;
    const int height = texture.on_device ? texture.on_device->height() : texture.height;
    const bool is_minified = width > pixels(area.width) || height > pixels(area.height);
    glSamplerParameteri(sampler_, GL_TEXTURE_MIN_FILTER, is_minified ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(sampler_, GL_TEXTURE_MAG_FILTER, is_minified ? GL_LINEAR : GL_NEAREST);
    glBindVertexArray(points_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glBindSampler(0, 0);
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
}

} // namespace glint::viewer
