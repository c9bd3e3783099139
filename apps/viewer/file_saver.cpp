// Writes the files, under names that do not exist yet.
#include "file_saver.h"

#include "messages.h"
#include "presenter.h"
#include "scene_editor.h"

#include "glint/picture_files.h"

#include <fmt/format.h>

#include <filesystem>

namespace glint::viewer {
namespace {

/// "picture.png", or the first of "picture-2.png", "picture-3.png" … that does not exist.
std::string free_name(const std::string& stem, const std::string& extension) {
    std::string name = stem + extension;
    std::error_code none;
    for (int i = 2; std::filesystem::exists(name, none); ++i)
        name = fmt::format("{}-{}{}", stem, i, extension);
    return name;
}

/// The file's path without its extension.
std::string stem_of(const std::string& file) {
    return std::filesystem::path(file).replace_extension().string();
}

} // namespace

void FileSaver::save_scene() {
    messages_.guarded([&] {
        last_file_ = editor_.save();
        messages_.show("Saved " + last_file_);
    });
}

void FileSaver::save_picture() {
    picture_wanted_ = true;
    if (!presenter_.is_finished()) messages_.show("The picture is saved when it is finished");
}

void FileSaver::finish_frame() {
    if (window_wanted_) write_screenshot();
    if (picture_wanted_ && presenter_.is_finished()) write_finished_picture();
}

void FileSaver::write_finished_picture() {
    picture_wanted_ = false;
    messages_.guarded([&] {
        const std::string file = free_name(stem_of(editor_.file()), ".png");
        write_picture(file, image_of(*editor_.frame()),
                      {.view = state_.view, .alpha = {}, .layers = {}, .metadata = {}});
        last_file_ = file;
        messages_.show("Saved " + file);
    });
}

void FileSaver::write_screenshot() {
    window_wanted_ = false;
    messages_.guarded([&] {
        const std::string stem = editor_.file().empty() ? "glint" : stem_of(editor_.file());
        const std::string file = free_name(stem + "-window", ".png");
        write_picture(file, window_.screenshot(),
                      {.view = View::raw, .alpha = {}, .layers = {}, .metadata = {}});
        last_file_ = file;
    });
}

void FileSaver::report(UiMap& map) const {
    if (!last_file_.empty()) map.state("saved", last_file_);
}

} // namespace glint::viewer
