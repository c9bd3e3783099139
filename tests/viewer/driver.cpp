#include "driver.h"

#include "../cli/process.h"

#include "glint/picture_files.h"
#include "glint/write_file.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace glint::test {

namespace fs = std::filesystem;

namespace {
constexpr double time_limit = 30;
}

void Screen::SetUp() {
    for (const char* program : {"Xvfb", "xdotool"})
        if (!is_installed(program)) GTEST_SKIP() << program << " is not installed: the window is not tested";
    folder_ = std::make_unique<TemporaryFolder>();
    server_ = std::make_unique<Child>(std::vector<std::string>{"Xvfb", "-displayfd", "3", "-screen", "0",
                                                               "1400x1200x24", "-nolisten", "tcp"},
                                      std::vector<std::string>{}, path("server_log"));
    const std::string number = server_->first_note();
    ASSERT_NE(number, "") << content("server_log");
    display_ = ":" + number;
}

void Screen::TearDown() {
    viewer_.reset();
    server_.reset();
    folder_.reset();
}

std::vector<std::string> Screen::display_setting() const {
    // Mesa leaks.
    return {"DISPLAY=" + display_, "LIBGL_ALWAYS_SOFTWARE=1", "ASAN_OPTIONS=detect_leaks=0"};
}

void Screen::open(const std::string& file, const std::vector<std::string>& options,
                  const std::vector<std::string>& environment) {
    std::vector<std::string> arguments{GLINT_VIEW_PROGRAM, "--ui-map", path("map")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    if (!file.empty()) arguments.push_back(path(file));
    std::vector<std::string> setting = display_setting();
    setting.insert(setting.end(), environment.begin(), environment.end());
    viewer_ = std::make_unique<Child>(arguments, setting, path("log"));
    ASSERT_TRUE(wait_until([&] { return exists("map") || viewer_->ended(); }));
    ASSERT_FALSE(viewer_->ended()) << log();
}

void Screen::write(const std::string& name, const std::string& text) const {
    write_file(path(name), std::as_bytes(std::span(text)));
}

std::string Screen::content(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

bool Screen::exists(const std::string& name) const { return fs::exists(path(name)); }

int Screen::count(const std::string& beginning) const {
    int found = 0;
    for (const auto& entry : fs::directory_iterator(folder_->path()))
        found += entry.path().filename().string().starts_with(beginning) ? 1 : 0;
    return found;
}

std::string Screen::path(const std::string& name) const { return folder_->at(name); }

nlohmann::json Screen::map() const { return nlohmann::json::parse(content("map")); }

nlohmann::json Screen::state(const std::string& name) const {
    const nlohmann::json all = map();
    const auto found = all["state"].find(name);
    return found == all["state"].end() ? nlohmann::json() : *found;
}

bool Screen::has(const std::string& widget) const { return map()["widgets"].contains(widget); }

Spot Screen::spot(const std::string& widget, double u, double v) const {
    const nlohmann::json all = map();
    if (!all["widgets"].contains(widget)) {
        ADD_FAILURE() << "no widget " << widget << " in " << all.dump(1);
        return {};
    }
    const nlohmann::json& area = all["widgets"][widget];
    return {area[0].get<double>() + u * area[2].get<double>(),
            area[1].get<double>() + v * area[3].get<double>()};
}

bool Screen::wait_until(const std::function<bool()>& holds) const {
    for (const double end = now() + time_limit; now() < end; sleep_for(0.02))
        if (holds()) return true;
    return false;
}

bool Screen::wait_for_state(const std::string& name, const nlohmann::json& value) const {
    return wait_until([&] { return state(name) == value; });
}

bool Screen::wait_for_widget(const std::string& widget) const {
    return wait_until([&] { return has(widget); });
}

std::string Screen::finished_picture() const {
    // Input takes a moment to arrive: the picture must stay finished.
    std::string last;
    int equal = 0;
    EXPECT_TRUE(wait_until([&] {
        const nlohmann::json all = map()["state"];
        const bool finished = all.value("finished", false);
        const std::string hash = all.value("picture_hash", "");
        equal = finished && hash == last ? equal + 1 : 0;
        last = hash;
        return equal >= 10;
    })) << "the picture is not finished: "
        << map().dump(1);
    return last;
}

void Screen::xdotool(const std::string& line) const {
    std::vector<std::string> arguments = words_of(line);
    arguments.insert(arguments.begin(), "/usr/bin/xdotool");
    Setting setting;
    setting.environment = display_setting();
    const Outcome outcome = run_program(arguments, setting);
    ASSERT_EQ(outcome.exit, 0) << line << ": " << outcome.err;
}

namespace {
std::string at(const Spot& spot) {
    return std::to_string(std::lround(spot.x)) + " " + std::to_string(std::lround(spot.y));
}
} // namespace

void Screen::click(const std::string& widget) const { click(spot(widget)); }

void Screen::click(const Spot& where, const std::string& button) const {
    // The window finds the widget under the mouse once a frame.
    xdotool("mousemove " + at(where) + " sleep 0.1 mousedown " + button + " sleep 0.08 mouseup " + button +
            " sleep 0.05");
}

void Screen::drag(const Spot& from, const Spot& to, const std::string& key, const std::string& button) const {
    std::string line = "mousemove " + at(from) + " sleep 0.1 ";
    if (!key.empty()) line += "keydown " + key + " ";
    line += "mousedown " + button + " sleep 0.08 ";
    constexpr int steps = 8;
    for (int i = 1; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        line +=
            "mousemove " + at({from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t}) + " sleep 0.03 ";
    }
    line += "mouseup " + button;
    if (!key.empty()) line += " keyup " + key;
    xdotool(line);
}

void Screen::press(const std::string& key) const { xdotool("key " + key); }

void Screen::wheel(const Spot& where, int notches) const {
    const std::string button = notches > 0 ? "4" : "5";
    xdotool("mousemove " + at(where) + " sleep 0.1 click --repeat " + std::to_string(std::abs(notches)) +
            " " + button);
}

int Screen::wrong_on_screen(const Image& file) {
    const Image screen = screenshot();
    const nlohmann::json all = map();
    const nlohmann::json area = all["widgets"]["picture"];
    int wrong = 0;
    std::string where;
    for (int y = 0; y < file.height; y += 7)
        for (int x = 0; x < file.width; x += 7) {
            const double sx = area[0].get<double>() + (x + 0.5) * area[2].get<double>() / file.width;
            const double sy = area[1].get<double>() + (y + 0.5) * area[3].get<double>() / file.height;
            const float* shown = screen.at(static_cast<int>(sx), static_cast<int>(sy));
            const int before = wrong;
            for (int c = 0; c < 3; ++c) wrong += std::abs(shown[c] - file.at(x, y)[c]) > 1.5f;
            if (wrong > before) where += fmt::format(" ({}, {})", x, y);
        }
    if (wrong > 0) std::cout << "wrong pixels:" << where << "\n" << all.dump(1) << "\n";
    return wrong;
}

Image Screen::screenshot() {
    press("F12");
    std::string name;
    EXPECT_TRUE(wait_until([&] {
        const nlohmann::json saved = state("saved");
        name = saved.is_string() ? saved.get<std::string>() : "";
        return name.find("-window") != std::string::npos && fs::exists(name);
    }));
    Image image = read_picture(name).image;
    fs::remove(name);
    return image;
}

double Screen::seconds_to_close() {
    const double start = now();
    press("ctrl+q");
    const double seconds = viewer_->wait(10) ? now() - start : -1;
    std::cout << "closed after " << seconds << " s\n";
    return seconds;
}

} // namespace glint::test
