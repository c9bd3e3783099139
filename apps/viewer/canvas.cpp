#include "canvas.h"

#include "glint/error.h"

#include <epoxy/gl.h>

#include <cmath>
#include <string>

namespace glint::viewer {
namespace {

constexpr const char* vertex_source = R"(#version 330 core
uniform vec4 corners; // of the area in the viewport: left, top, right, bottom
out vec2 place;
void main() {
    place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(corners.xy, corners.zw, place), 0.0, 1.0);
}
)";

// As little as can be: software that draws OpenGL has a short way for it.
constexpr const char* plain_source = R"(#version 330 core
uniform sampler2D picture;
in vec2 place;
out vec4 color;
void main() { color = texture(picture, place); }
)";

// For linear light: the exact sRGB curve, as pictures in files have it.
constexpr const char* bent_source = R"(#version 330 core
uniform sampler2D picture;
in vec2 place;
out vec4 color;
void main() {
    vec3 light = clamp(texture(picture, place).rgb, 0.0, 1.0);
    vec3 bent = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    color = vec4(mix(light * 12.92, bent, greaterThan(light, vec3(0.0031308))), 1.0);
}
)";

unsigned compiled(GLenum kind, const char* source) {
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

unsigned linked(const char* fragment_source) {
    const unsigned vertex = compiled(GL_VERTEX_SHADER, vertex_source);
    const unsigned fragment = compiled(GL_FRAGMENT_SHADER, fragment_source);
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
    : name(linked(fragment_source)), corners(glGetUniformLocation(name, "corners")) {}

Canvas::Canvas() : plain_(plain_source), bent_(bent_source) {
    glGenVertexArrays(1, &points_);
    for (Texture& texture : pictures_) glGenTextures(1, &texture.name);
    // Not each texture's own setting: some come from elsewhere.
    glGenSamplers(1, &sampler_);
    glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Canvas::~Canvas() {
    for (const Texture& texture : pictures_) glDeleteTextures(1, &texture.name);
    glDeleteSamplers(1, &sampler_);
    glDeleteVertexArrays(1, &points_);
    for (const Program* program : {&plain_, &bent_}) glDeleteProgram(program->name);
}

void Canvas::upload(int place, int width, int height, const std::vector<std::uint32_t>& pixels) {
    Texture& texture = pictures_[static_cast<std::size_t>(place)];
    texture.on_device.reset();
    glBindTexture(GL_TEXTURE_2D, texture.name);
    // Packed as graphics cards keep it: nothing is to be converted.
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

void Canvas::show(int place, std::shared_ptr<const GpuPicture> picture) {
    pictures_[static_cast<std::size_t>(place)].on_device = std::move(picture);
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

void Canvas::draw(int place, const Area& area, const Area& part, View view, const WindowSize& window) const {
    const float ratio = window.pixels_a_unit();
    const auto pixels = [ratio](float units) { return static_cast<GLint>(std::lround(units * ratio)); };
    const GLint bottom = window.pixel_height - pixels(part.y + part.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixels(part.x), bottom, pixels(part.x + part.width) - pixels(part.x),
              pixels(part.y + part.height) - pixels(part.y));
    glDisable(GL_BLEND);
    const Texture& texture = pictures_[static_cast<std::size_t>(place)];
    // The card's own picture is linear light; one uploaded has its colours already.
    const Program& program = texture.on_device && view == View::srgb ? bent_ : plain_;
    glUseProgram(program.name);
    const auto across = [&](float x) { return 2 * x / static_cast<float>(window.width) - 1; };
    const auto upward = [&](float y) { return 1 - 2 * y / static_cast<float>(window.height); };
    glUniform4f(program.corners, across(area.x), upward(area.y), across(area.x + area.width),
                upward(area.y + area.height));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.on_device ? texture.on_device->texture() : texture.name);
    glBindSampler(0, sampler_);
    // Where a pixel of the picture covers one of the screen or more, its edges stay sharp.
    const int width = texture.on_device ? texture.on_device->width() : texture.width;
    const int height = texture.on_device ? texture.on_device->height() : texture.height;
    const bool shrunk = width > pixels(area.width) || height > pixels(area.height);
    glSamplerParameteri(sampler_, GL_TEXTURE_MIN_FILTER, shrunk ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(sampler_, GL_TEXTURE_MAG_FILTER, shrunk ? GL_LINEAR : GL_NEAREST);
    glBindVertexArray(points_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glBindSampler(0, 0);
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
}

} // namespace glint::viewer
