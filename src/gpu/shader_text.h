#pragma once
// The text of the shader, file by file, in the order in which it is compiled.

namespace glint::gpu {

struct ShaderFile {
    const char* path; ///< below src/; null after the last
    const char* text;
};
extern const ShaderFile shader_files[];

} // namespace glint::gpu
