#pragma once
// Files of this room that the library contains, embedded by the build (cmake/EmbedText.cmake).

#include <string_view>

namespace glint::formats {

struct EmbeddedFile {
    const char* name; ///< below src/
    const char* text;
};
extern const EmbeddedFile embedded_files[]; ///< ends with one without a name

/// The text of the file with that name; empty if there is none.
inline std::string_view embedded_text(std::string_view name) {
    const EmbeddedFile* file = embedded_files;
    while (file->name != nullptr && file->name != name) ++file;
    return file->name != nullptr ? file->text : "";
}

} // namespace glint::formats
