#pragma once
// The files in texts/, embedded by the build (cmake/EmbedText.cmake): hand-written beginnings of scenes, and
// the text of
// --help.

namespace glint::meshgen {

struct EmbeddedText {
    const char* path; ///< below tools/
    const char* text;
};
enum { flake_head, city_head, spiral_head, help_text };
extern const EmbeddedText embedded_texts[]; ///< in the order of the enumeration

} // namespace glint::meshgen
