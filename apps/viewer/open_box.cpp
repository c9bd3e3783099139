// Reads folders with the standard library and lists them with Dear ImGui.
#include "open_box.h"

#include "widgets.h"

#include <imgui.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace glint::viewer {
namespace {

namespace fs = std::filesystem;

/// Those that are installed beside the program, or those of the sources it was built from.
fs::path examples_folder() {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    for (const fs::path& folder : {program / "../share/glint/scenes", program / "../../../../scenes"})
        if (fs::is_directory(folder, none)) return fs::weakly_canonical(folder, none);
    return {};
}

bool can_be_shown(const fs::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".toml" || extension == ".ply";
}

} // namespace

OpenBox::OpenBox() : examples_(examples_folder()) {
    std::error_code unknown;
    enter(fs::current_path(unknown));
}

bool OpenBox::close() { return std::exchange(open_, false); }

void OpenBox::enter(const fs::path& folder) {
    folder_ = folder;
    folders_ = {};
    files_ = {};
    // Folders that cannot be read are empty.
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with('.')) continue;
        if (entry.is_directory(failed))
            folders_.push_back(name);
        else if (can_be_shown(entry.path()))
            files_.push_back(name);
    }
    std::ranges::sort(folders_);
    std::ranges::sort(files_);
    if (folder.has_relative_path()) folders_.insert(folders_.begin(), "..");
}

std::optional<std::string> OpenBox::draw_list(Ui& ui) {
    std::optional<fs::path> entered;
    std::optional<std::string> chosen;
    for (const std::string& name : folders_) {
        if (ImGui::Selectable((name + "/").c_str())) entered = (folder_ / name).lexically_normal();
        ui.map.item("folder:" + name);
    }
    for (const std::string& name : files_) {
        if (ImGui::Selectable(name.c_str())) chosen = (folder_ / name).string();
        ui.map.item("file:" + name);
    }
    if (files_.empty()) quiet_text(ui, "no scene (.toml) or mesh (.ply) here");
    // ".." of "a/b" is "a/b/..", normally "a/".
    if (entered) enter(entered->has_filename() ? *entered : entered->parent_path());
    return chosen;
}

std::optional<std::string> OpenBox::draw(Ui& ui, const Area& space, bool always) {
    if (!open_ && !always) return std::nullopt;
    const float letter = ImGui::GetFontSize();
    const ImVec2 size(std::min(30 * letter, space.width), std::min(24 * letter, 0.9f * space.height));
    ImGui::SetNextWindowPos({space.x + space.width / 2, space.y + space.height / 2}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowBgAlpha(0.97f);
    ImGui::Begin("open", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    heading(ui, "Open");
    quiet_text(ui, "Drop a scene (.toml) or a mesh (.ply) here, or choose one.");
    if (!examples_.empty() && button(ui, "examples", "Examples")) enter(examples_);
    quiet_text(ui, folder_.string());
    ImGui::BeginChild("files", {0, 0}, true);
    std::optional<std::string> chosen = draw_list(ui);
    ImGui::EndChild();
    const ImVec2 corner = ImGui::GetWindowPos();
    ui.map.area("open", {corner.x, corner.y, size.x, size.y});
    ImGui::End();
    if (chosen) open_ = false;
    return chosen;
}

} // namespace glint::viewer
