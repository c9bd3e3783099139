// Fonts, spacing and the two colour schemes.
#include "theme.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <array>
#include <filesystem>

namespace glint::viewer {
namespace {

constexpr float text_height = 15;

/// Loads the first font found, in the folders of Linux and BSD systems.
ImFont* load_font(const std::vector<const char*>& files, float height) {
    // Latin, Greek, dashes, sub- and superscripts, arrows, mathematical signs, boxes.
    static const std::array<ImWchar, 19> ranges{0x0020, 0x017f, 0x0370, 0x03ff, 0x1d62, 0x1d6a, 0x2010,
                                                0x205e, 0x2070, 0x209f, 0x2190, 0x21ff, 0x2200, 0x22ff,
                                                0x25a0, 0x25ff, 0x2713, 0x2717, 0};
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    for (const char* folder : {"/usr/share/fonts/truetype/", "/usr/share/fonts/", "/usr/local/share/fonts/"})
        for (const char* file : files) {
            const std::string path = std::string(folder) + file;
            std::error_code fault;
            if (!std::filesystem::exists(path, fault)) continue;
            if (ImFont* font =
                    ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), height, &config, ranges.data()))
                return font;
        }
    config.SizePixels = height;
    return ImGui::GetIO().Fonts->AddFontDefault(&config);
}

void load_fonts(Theme& theme, float pixels_per_unit) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    // Glyphs are rasterised in pixels and laid out in units.
    const float height = text_height * theme.scale * pixels_per_unit;
    theme.text = load_font(
        {"dejavu/DejaVuSans.ttf", "noto/NotoSans-Regular.ttf", "liberation/LiberationSans-Regular.ttf"},
        height);
    theme.bold = load_font(
        {"dejavu/DejaVuSans-Bold.ttf", "noto/NotoSans-Bold.ttf", "liberation/LiberationSans-Bold.ttf"},
        height);
    theme.fixed = load_font({"dejavu/DejaVuSansMono.ttf", "noto/NotoSansMono-Regular.ttf",
                             "liberation/LiberationMono-Regular.ttf"},
                            height * 0.93f);
    io.FontGlobalScale = 1 / pixels_per_unit;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void set_spacing(float scale) {
    ImGuiStyle style;
    style.WindowPadding = {14, 12};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 11;
    style.WindowRounding = 0;
    style.ChildRounding = 4;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.GrabRounding = 4;
    style.ScrollbarRounding = 6;
    style.TabRounding = 4;
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 0;
    style.PopupBorderSize = 1;
    style.WindowMinSize = {16, 16};
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

ImVec4 grey(float value, float alpha = 1) { return {value, value, value * 1.02f, alpha}; }

/// `level(x)`: a grey between the panel's background at 0 and the strongest text at 1.
template <typename Level>
void set_colors(const Theme& theme, const Level& level) {
    auto& colors = ImGui::GetStyle().Colors;
    colors[ImGuiCol_Text] = level(0.9f);
    colors[ImGuiCol_TextDisabled] = level(0.52f);
    colors[ImGuiCol_WindowBg] = level(0);
    colors[ImGuiCol_ChildBg] = {0, 0, 0, 0};
    colors[ImGuiCol_PopupBg] = level(0.03f);
    colors[ImGuiCol_Border] = level(0.16f);
    colors[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
    colors[ImGuiCol_FrameBg] = level(0.085f);
    colors[ImGuiCol_FrameBgHovered] = level(0.13f);
    colors[ImGuiCol_FrameBgActive] = level(0.16f);
    colors[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
    colors[ImGuiCol_ScrollbarGrab] = level(0.2f);
    colors[ImGuiCol_ScrollbarGrabHovered] = level(0.28f);
    colors[ImGuiCol_ScrollbarGrabActive] = level(0.35f);
    colors[ImGuiCol_CheckMark] = color_of(theme.accent);
    colors[ImGuiCol_TitleBg] = level(0.06f);
    colors[ImGuiCol_TitleBgActive] = level(0.06f);
    colors[ImGuiCol_SliderGrab] = color_of(theme.accent, 0.7f);
    colors[ImGuiCol_SliderGrabActive] = color_of(theme.accent);
    colors[ImGuiCol_Button] = level(0.11f);
    colors[ImGuiCol_ButtonHovered] = level(0.17f);
    colors[ImGuiCol_ButtonActive] = level(0.24f);
    colors[ImGuiCol_Header] = level(0.07f);
    colors[ImGuiCol_HeaderHovered] = level(0.12f);
    colors[ImGuiCol_HeaderActive] = level(0.15f);
    colors[ImGuiCol_Separator] = level(0.12f);
    colors[ImGuiCol_SeparatorHovered] = color_of(theme.accent, 0.5f);
    colors[ImGuiCol_SeparatorActive] = color_of(theme.accent);
    colors[ImGuiCol_Tab] = level(0);
    colors[ImGuiCol_TabHovered] = level(0.14f);
    colors[ImGuiCol_TabActive] = level(0.11f);
    colors[ImGuiCol_TableBorderLight] = level(0.1f);
    colors[ImGuiCol_TableBorderStrong] = level(0.16f);
    colors[ImGuiCol_TableRowBgAlt] = level(0.03f);
    colors[ImGuiCol_PlotHistogram] = color_of(theme.accent, 0.9f);
    colors[ImGuiCol_TextSelectedBg] = color_of(theme.accent, 0.35f);
    colors[ImGuiCol_NavHighlight] = color_of(theme.accent, 0.8f);
    colors[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45f};
}

} // namespace

ImVec4 color_of(const Tint& tint, float alpha) { return {tint.red, tint.green, tint.blue, alpha}; }

Theme apply_theme(ThemeChoice choice, float scale, float pixels_per_unit) {
    Theme theme;
    theme.choice = choice;
    theme.scale = scale;
    theme.pixels_per_unit = pixels_per_unit;
    load_fonts(theme, pixels_per_unit);
    set_spacing(scale);
    if (choice == ThemeChoice::dark) {
        theme.surround = {0.075f, 0.078f, 0.085f};
        theme.accent = {0.96f, 0.69f, 0.25f};
        theme.quiet = {0.56f, 0.57f, 0.59f};
        theme.warning = {0.96f, 0.77f, 0.35f};
        theme.error = {0.98f, 0.45f, 0.40f};
        set_colors(theme, [](float x) { return grey(0.125f + x * 0.82f); });
    } else {
        theme.surround = {0.80f, 0.80f, 0.81f};
        theme.accent = {0.76f, 0.42f, 0.02f};
        theme.quiet = {0.42f, 0.43f, 0.45f};
        theme.warning = {0.62f, 0.40f, 0.0f};
        theme.error = {0.75f, 0.13f, 0.10f};
        set_colors(theme, [](float x) { return grey(0.955f - x * 0.88f); });
    }
    const ImVec4& background = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    theme.panel = {background.x, background.y, background.z};
    return theme;
}

} // namespace glint::viewer
