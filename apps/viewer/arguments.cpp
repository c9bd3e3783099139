// The options of glint-view for CLI11.
#include "arguments.h"

#include "glint/render.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace glint::viewer {
namespace {

std::string override_fault(const std::string& text) {
    const bool sets = text.find('=') != std::string::npos && text.front() != '=';
    return sets ? "" : "\"" + text + "\" sets nothing; expected path=value, such as whitted.max_depth=3";
}

void add_size(CLI::App& app, const char* name, auto& size, int min, const char* help) {
    const auto take = [name, min, &size](const std::string& text) {
        constexpr int max = 8192;
        std::istringstream in(text);
        int width = 0, height = 0;
        char separator = 0;
        in >> width >> separator >> height;
        const bool is_size = in && separator == 'x' && in.peek() == EOF;
        if (!is_size || std::min(width, height) < min || std::max(width, height) > max)
            throw CLI::ValidationError(name, "expected WxH such as 1280x720, each number from " +
                                                 std::to_string(min) + " to " + std::to_string(max));
        size = std::pair(width, height);
    };
    app.add_option_function<std::string>(name, take, help)->type_name("WxH");
}

void add_flag(CLI::App& app, const char* name, bool& flag, const char* help) {
    app.add_flag(name, flag, help)->disable_flag_override();
}

/// Options of which one of several words is chosen.
struct Choices {
    std::string up = "auto", backend = "auto", theme = "dark";
};

void add_options(CLI::App& app, Arguments& a, Choices& choices) {
    app.set_version_flag("--version", std::string("glint-view ") + version(), "the version");
    app.add_option("FILE", a.file, "a scene or a mesh");
    // Of an option that is given twice, the last value counts.
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    add_size(app, "--size", a.picture_size, 1, "of the picture; default: as many pixels as the window shows");
    add_size(app, "--window", a.window_size, 320, "of the window, times what the screen asks for");
    app.add_option("-D", a.load.overrides, "set one value of the scene: -D material.glass.index=1.33")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name("PATH=VALUE")
        ->check(override_fault);
    app.add_option("--up", choices.up, "the axis of a bare mesh that points up")
        ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z", "auto"}));
    add_flag(app, "--allow-outside", a.load.allow_outside, "let a scene read files outside its own folder");
    app.add_option("-t,--threads", a.threads, "default: one for each processor that may be used")
        ->check(CLI::Range(0, 1024));
    app.add_option("--backend", choices.backend, "what renders; auto: a card where there is one")
        ->check(CLI::IsMember({"cpu", "gpu", "auto"}));
    app.add_option("--theme", choices.theme, "colours of the window")
        ->check(CLI::IsMember({"dark", "light"}));
    app.add_option("--scale", a.scale, "of texts and buttons; default: what the screen asks for");
    add_flag(app, "--ui-stats", a.statistics, "print how long the window took to draw, at its end");
    add_flag(app, "--ui-debug", a.debug, "print the debug messages of OpenGL");
    app.add_option("--ui-map", a.map_file, "keep writing where the widgets are, for scripts")
        ->type_name("FILE");
}

} // namespace

std::optional<Arguments> parse_arguments(const std::vector<std::string>& words, std::string& text) {
    CLI::App app("Shows a scene or a mesh in a window, in which ? lists keys and gestures.", "glint-view");
    Arguments a;
    Choices choices;
    add_options(app, a, choices);
    try {
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::CallForHelp&) {
        text = app.help();
        return std::nullopt;
    } catch (const CLI::CallForVersion& asked) {
        text = asked.what() + std::string("\n");
        return std::nullopt;
    } catch (const CLI::ParseError& fault) {
        throw Error(ErrorKind::usage, fault.what(), "see glint view --help");
    }
    // NaN fails the comparison too.
    if (a.scale && !(*a.scale >= 0.5 && *a.scale <= 4))
        throw Error(ErrorKind::usage, "--scale is not a number from 0.5 to 4");
    if (a.file == "-")
        throw Error(ErrorKind::usage, "a window shows files, not standard input", "name a file");
    a.load.up = value_named<Axis>(choices.up);
    if (choices.theme == "light") a.theme = ThemeChoice::light;
    if (choices.backend != "auto")
        a.backend = choices.backend == "gpu" ? BackendChoice::gpu : BackendChoice::cpu;
    return a;
}

} // namespace glint::viewer
