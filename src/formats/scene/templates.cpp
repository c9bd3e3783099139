// The templates of `glint new`: the files in formats/scene/templates.

#include "formats/embedded.h"
#include "glint/scene_files.h"
#include "scene/text.h"

namespace glint {
namespace {

constexpr std::string_view folder = "formats/scene/templates/";
constexpr std::string_view extension = ".toml";

} // namespace

std::vector<std::string> template_names() {
    std::vector<std::string> names;
    for (const formats::EmbeddedFile* file = formats::embedded_files; file->name != nullptr; ++file) {
        std::string_view name = file->name;
        if (!name.starts_with(folder)) continue;
        name.remove_prefix(folder.size());
        name.remove_suffix(extension.size());
        names.emplace_back(name);
    }
    return names;
}

std::string template_text(const std::string& name) {
    const std::string_view text = formats::embedded_text(std::string(folder) + name + std::string(extension));
    if (!text.empty()) return std::string(text);
    throw Error(ErrorKind::usage, "unknown template " + scene::in_quotes(name),
                did_you_mean(name, template_names(), "expected one of " + scene::listed(template_names())));
}

} // namespace glint
