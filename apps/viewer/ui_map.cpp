// The map as JSON.
#include "ui_map.h"

#include "glint/error.h"

#include <imgui.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace glint::viewer {

void UiMap::begin() {
    areas_.clear();
    states_.clear();
}

void UiMap::item(const std::string& name) {
    if (!is_enabled() || !ImGui::IsItemVisible()) return;
    const ImVec2 corner = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    area(name, {corner.x, corner.y, size.x, size.y});
}

void UiMap::area(const std::string& name, const Area& area) {
    if (is_enabled()) areas_[name] = area;
}

void UiMap::state(const std::string& name, Value value) {
    if (is_enabled()) states_[name] = std::move(value);
}

void UiMap::end() {
    if (!is_enabled()) return;
    nlohmann::ordered_json document;
    auto& widgets = document["widgets"] = nlohmann::ordered_json::object();
    for (const auto& [name, area] : areas_) widgets[name] = {area.x, area.y, area.width, area.height};
    auto& state = document["state"] = nlohmann::ordered_json::object();
    for (const auto& [name, value] : states_)
        std::visit([&state, &key = name](const auto& held) { state[key] = held; }, value);
    std::string text = document.dump(1) + "\n";
    if (text == written_) return;
    // Atomic, but without fsync: it is written many times a second.
    const std::string draft = file_ + ".part";
    std::ofstream(draft, std::ios::binary) << text;
    std::error_code fault;
    std::filesystem::rename(draft, file_, fault);
    if (fault) throw Error(ErrorKind::output, "cannot write \"" + file_ + "\": " + fault.message());
    written_ = std::move(text);
}

} // namespace glint::viewer
