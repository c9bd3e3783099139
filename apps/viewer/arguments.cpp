// The table of options and the parser.
#include "arguments.h"

#include <fmt/format.h>

#include <charconv>
#include <functional>

namespace glint::viewer {
namespace {

/// One option: its spellings, the name of its value (empty: a flag), its help, and its effect.
struct Option {
    std::vector<std::string> names;
    std::string value;
    std::string help;
    std::function<void(Arguments&, const std::string&)> take;
};

[[noreturn]] void refuse(const std::string& name, const std::string& given, const std::string& expected) {
    throw Error(ErrorKind::usage, fmt::format("{} \"{}\" is not valid", name, given), "expected " + expected);
}

int whole(const std::string& name, const std::string& text, int min, int max) {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    if (fault != std::errc() || stop != end || number < min || number > max)
        refuse(name, text, fmt::format("a whole number from {} to {}", min, max));
    return number;
}

struct Size {
    int width = 0;
    int height = 0;
};

Size size(const std::string& name, const std::string& text, int min, int max) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) refuse(name, text, "WxH such as 1280x720");
    return {whole(name, text.substr(0, cross), min, max), whole(name, text.substr(cross + 1), min, max)};
}

double scale_of(const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    // NaN fails the comparison too.
    if (fault != std::errc() || stop != end || !(number >= 0.5 && number <= 4))
        refuse("--scale", text, "a number from 0.5 to 4");
    return number;
}

void take_override(Arguments& a, const std::string& text) {
    if (text.find('=') == std::string::npos || text.front() == '=')
        throw Error(ErrorKind::usage, "-D \"" + text + "\" sets nothing",
                    "expected path=value, such as -D whitted.max_depth=3");
    a.load.overrides.push_back(text);
}

void take_up(Arguments& a, const std::string& text) {
    if (text != "y" && text != "z" && text != "auto") refuse("--up", text, "y, z or auto");
    a.load.up.reset();
    if (text == "y") a.load.up = Axis::y;
    if (text == "z") a.load.up = Axis::z;
}

void take_theme(Arguments& a, const std::string& text) {
    if (text != "dark" && text != "light") refuse("--theme", text, "dark or light");
    a.theme = text == "light" ? ThemeChoice::light : ThemeChoice::dark;
}

void take_backend(Arguments& a, const std::string& text) {
    if (text != "cpu" && text != "gpu" && text != "auto") refuse("--backend", text, "cpu, gpu or auto");
    a.backend = text == "cpu"   ? BackendChoice::cpu
                : text == "gpu" ? BackendChoice::gpu
                                : BackendChoice::automatic;
}

const std::vector<Option>& options() {
    static const std::vector<Option> table = {
        {{"--size"},
         "WxH",
         "pixels to render; default: as many as the window shows",
         [](Arguments& a, const std::string& text) {
             const Size given = size("--size", text, 1, 8192);
             a.picture_width = given.width;
             a.picture_height = given.height;
         }},
        {{"--window"},
         "WxH",
         "size of the window, times what the screen asks for; default: 1280x800",
         [](Arguments& a, const std::string& text) {
             const Size given = size("--window", text, 320, 8192);
             a.window_width = given.width;
             a.window_height = given.height;
         }},
        {{"-D"}, "PATH=VALUE", "set one value of the scene: -D material.glass.index=1.33", take_override},
        {{"--up"}, "y|z|auto", "the axis of a bare mesh that points up", take_up},
        {{"--allow-outside"},
         "",
         "let a scene read files outside its own folder",
         [](Arguments& a, const std::string&) { a.load.allow_outside = true; }},
        {{"-t", "--threads"},
         "N",
         "default: one for each core",
         [](Arguments& a, const std::string& text) { a.threads = whole("--threads", text, 0, 1024); }},
        {{"--backend"},
         "cpu|gpu|auto",
         "what renders; default: auto, a card where there is one",
         take_backend},
        {{"--theme"}, "dark|light", "colours of the window", take_theme},
        {{"--scale"},
         "S",
         "of texts and buttons; default: what the screen asks for",
         [](Arguments& a, const std::string& text) { a.scale = scale_of(text); }},
        {{"--ui-stats"},
         "",
         "print how long the window took to draw, at its end",
         [](Arguments& a, const std::string&) { a.statistics = true; }},
        {{"--ui-debug"},
         "",
         "print what OpenGL complains of",
         [](Arguments& a, const std::string&) { a.debug = true; }},
        {{"--ui-map"},
         "FILE",
         "keep writing where the widgets are, for scripts",
         [](Arguments& a, const std::string& text) { a.map_file = text; }},
        {{"-h", "--help"}, "", "this help", [](Arguments& a, const std::string&) { a.help = true; }},
        {{"--version"}, "", "the version", [](Arguments& a, const std::string&) { a.version = true; }},
    };
    return table;
}

const Option& find_option(const std::string& name) {
    std::vector<std::string> names;
    for (const Option& option : options())
        for (const std::string& spelling : option.names) {
            if (spelling == name) return option;
            if (spelling.size() > 2) names.push_back(spelling.substr(2));
        }
    const std::size_t letters = name.find_first_not_of('-');
    const auto near = nearest_name(letters == std::string::npos ? name : name.substr(letters), names);
    throw Error(ErrorKind::usage, fmt::format("unknown option \"{}\"", name),
                near ? fmt::format("did you mean \"--{}\"?", *near) : "see glint view --help");
}

void take_file(Arguments& parsed, const std::string& name) {
    if (!parsed.file.empty()) throw Error(ErrorKind::usage, "more than one scene given");
    if (name.empty()) throw Error(ErrorKind::usage, "a name is empty");
    parsed.file = name;
}

/// Takes the option at `index` and moves on to its value, if that is an argument of its own.
void take_option(Arguments& parsed, const std::vector<std::string>& arguments, std::size_t& index) {
    const std::string& argument = arguments[index];
    // --name=value and --name value are the same.
    const std::size_t equals = argument.rfind("--", 0) == 0 ? argument.find('=') : std::string::npos;
    const bool has_value = equals != std::string::npos;
    const Option& option = find_option(argument.substr(0, equals));
    std::string value = has_value ? argument.substr(equals + 1) : "";
    if (!option.value.empty() && !has_value) {
        if (++index == arguments.size())
            throw Error(ErrorKind::usage, fmt::format("{} needs a value: {}", argument, option.value),
                        option.help);
        value = arguments[index];
    }
    if (option.value.empty() && has_value)
        throw Error(ErrorKind::usage, option.names.back() + " takes no value");
    option.take(parsed, value);
}

} // namespace

Arguments parse_arguments(const std::vector<std::string>& arguments) {
    Arguments parsed;
    bool only_files = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        if (argument == "--" && !only_files)
            only_files = true;
        else if (only_files || argument.size() < 2 || argument.front() != '-')
            take_file(parsed, argument);
        else
            take_option(parsed, arguments, i);
    }
    if (parsed.file == "-")
        throw Error(ErrorKind::usage, "a window shows files, not standard input", "name a file");
    return parsed;
}

std::string help_text() {
    std::string text = "usage: glint-view [FILE] [options]     show a scene or a mesh in a window\n";
    for (const Option& option : options())
        text += fmt::format("{:<38} {}\n",
                            fmt::format("{}{}{}{}", option.names.front().size() > 2 ? "      " : "  ",
                                        fmt::join(option.names, ", "), option.value.empty() ? "" : " ",
                                        option.value),
                            option.help);
    return text + "In the window, ? lists keys and gestures.\n";
}

} // namespace glint::viewer
