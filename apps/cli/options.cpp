#include "options.h"

#include "glint/kernels.h"
#include "glint/scene.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace glint::cli {
namespace {

/// The names of a table with "|" between them, made without memory: it may be lacking before main() too.
template <const auto& names>
constexpr auto joined_names = [] {
    std::array<char, 64> text{};
    std::size_t length = 0;
    for (const std::string_view name : names) {
        if (length > 0) text[length++] = '|';
        for (const char letter : name) text[length++] = letter;
    }
    return text;
}();

// Options of more than one command.
constexpr Option size{0, "size", "WxH", "pixels, such as 1280x720; default: the scene's", false, true};
constexpr Option spp{0, "spp", "N|A..B", "samples per pixel; 1..16: 16 where neighbours differ", false, true};
constexpr Option max_depth{0, "max-depth", "N", "bounces after the first hit"};
constexpr Option seed{0, "seed", "N", "of the random numbers"};
constexpr Option set{'D',   "",  "PATH=VALUE", "set one value of the scene: -D material.glass.index=1.33",
                     false, true};
constexpr Option frame{0, "frame", "N", "of an animated scene: as it is at this frame"};
constexpr Option up{0, "up", "x|y|z|-x|-y|-z|auto", "the axis of a bare mesh that points up"};
constexpr Option allow_outside{0, "allow-outside", "", "let a scene read files outside its own folder"};
constexpr Option threads{'t',   "threads", "N", "default: one for each processor that may be used",
                         false, true};
constexpr Option color{0, "color", "auto|always|never", "colours in messages; auto heeds NO_COLOR and TERM"};
constexpr Option quiet{'q', "quiet", "", "print errors only", false, true};
constexpr Option verbose{'v', "verbose", "", "say more", true};
constexpr Option help{'h', "help", "", "this help", true};

// The choices of kernels, SIMD targets, views and integrators are in the order of the enumerations.
const std::array render_options{
    Option{'o', "output", "FILE", ".png, .exr, .pfm, or - for PNG on stdout; default: STEM.png", false, true},
    size,
    spp,
    max_depth,
    Option{0, "integrator", joined_names<enum_names<Integrator>>.data(), "the light model"},
    seed,
    Option{0, "dry-run", "", "check only, print the memory needed", true},
    Option{0, "crop", "X,Y,W,H", "only this part, pixels from the top left"},
    Option{0, "frames", "A..B[:STEP]", "or all, of what moves: one file each, -o frame-%04d.png"},
    up,
    set,
    allow_outside,
    Option{0, "show", "WHAT", "shadows, normal, depth, cost, or a term such as diffuse"},
    Option{0, "view", "srgb|raw", "PNG: the sRGB curve, or plain numbers"},
    Option{0, "bits", "8|16", "bits per channel", true},
    Option{0, "alpha", "", "PNG, EXR: coverage as alpha"},
    Option{0, "layers", "", "EXR: each term as a layer", true},
    Option{0, "keep-partial", "", "Ctrl-C writes what there is"},
    Option{0, "stats", "FILE", "counts, rays and times as JSON", true},
    threads,
    Option{0, "tile-size", "N", "pixels; changes the order of the work, never the picture"},
    Option{0, "backend", "cpu|gpu|auto", "where to render; default: cpu"},
    Option{0, "kernel", joined_names<kernel_names>.data(), "of the tracing: only the time changes"},
    Option{0, "simd", "auto|plain|sse4|avx2|avx512", "vectors of the tracing; auto: the machine's widest"},
    Option{0, "progress", "auto|plain|json|none", "on stderr; auto: a bar on a terminal, else plain"},
    color,
    quiet,
    verbose,
    help,
};

// glint-view takes the same; a test compares the two lists.
constexpr std::array view_options{
    Option{0, "size", "WxH", "pixels to render; default: as many as the window shows"},
    Option{0, "window", "WxH", "size of the window; default: 1280x800"},
    set,
    up,
    allow_outside,
    threads,
    Option{0, "backend", "cpu|gpu|auto", "what renders; default: auto, a card where there is one"},
    Option{0, "theme", "dark|light", "colours of the window"},
    Option{0, "scale", "S", "of texts and buttons; default: what the screen asks for"},
    Option{0, "ui-stats", "", "print how long the window took to draw, at its end"},
    Option{0, "ui-debug", "", "print the debug messages of OpenGL"},
    Option{0, "ui-map", "FILE", "keep writing where the widgets are, for scripts"},
    Option{'h', "help", "", "this help"},
};

constexpr std::array check_options{
    Option{0, "frames", "A..B[:STEP]", "check these frames of animated scenes; default: all"},
    Option{0, "json", "", "for programs"},
    set,
    up,
    allow_outside,
    color,
    quiet,
    help};

constexpr std::array info_options{
    Option{0, "json", "", "for programs"},
    Option{0, "devices", "", "instead of FILE: what --backend gpu can use, and why not"},
    frame,
    set,
    up,
    allow_outside,
    threads,
    color,
    quiet,
    help,
};

constexpr std::array explain_options{
    Option{0, "pixel", "X,Y", "which; 0,0 is top left; html: shown first"},
    frame,
    Option{0, "ray", "N", "text: every step of ray N of the tree"},
    Option{0, "steps", "", "of all rays", true},
    Option{0, "sample", "N", "text: the rays of sample N; default: 0"},
    Option{0, "format", "text|json|svg|html", "default: by the extension of -o, else text; html: all pixels"},
    Option{0, "grid", "WxH", "html: pixels that can be asked; default: 160x90"},
    Option{0, "backend", "cpu|gpu|auto", "gpu: tell how far a card's pixel is from the CPU's"},
    Option{'o', "output", "FILE", "where to; default: stdout"},
    size,
    spp,
    max_depth,
    seed,
    up,
    set,
    allow_outside,
    threads,
    color,
    quiet,
    verbose,
    help,
};

constexpr std::array diff_options{
    Option{'o', "output", "FILE", "a picture of the differences; white is the largest"},
    Option{0, "metric", "max|mae|rmse|psnr|share", "what decides; default: max"},
    Option{0, "tolerance", "T", "how far it may go; default: 0, for psnr: inf"},
    color,
    quiet,
    help,
};

constexpr std::array new_options{
    Option{'o', "output", "FILE", "where to; default: stdout"},
    Option{0, "from", "MESH", "a scene around this mesh; TEMPLATE mesh: on a turntable"},
    up,
    Option{0, "force", "", "overwrite FILE"},
    Option{0, "list", "", "list the templates"},
    color,
    quiet,
    help,
};

const std::array command_table{
    Command{"render", "FILE [-o OUT]", "render a scene or a mesh to a picture", Operands::scene,
            render_options, ""},
    Command{"view", "[FILE]", "show a scene or a mesh in a window", Operands::maybe_scene, view_options,
            "In the window, ? lists keys and gestures.\n"
            "Exit: 0 closed; 3 FILE cannot be read; 7 no display, or glint-view is not installed."},
    Command{"check", "FILE...", "find all errors and warnings, render nothing", Operands::scenes,
            check_options, "Exit: 0 good, perhaps with warnings; 3 a file has errors."},
    Command{"info", "FILE", "counts, bounds, materials, memory, tree", Operands::scene, info_options, ""},
    Command{"explain", "FILE --pixel X,Y", "why a pixel has its colour, term by term", Operands::scene,
            explain_options, ""},
    Command{"diff", "A B", "compare two pictures", Operands::two_pictures, diff_options,
            "Pictures with 8 or 16 bits are compared in units of 1/255, float ones in linear light.\n"
            "  max mae rmse   fail above T, in those units\n"
            "  psnr           fails below T dB\n"
            "  share          fails where more than this share (0 to 1) of the pixels is off by\n"
            "                 more than 1/255 in a channel\n"
            "Exit: 0 within the tolerance, 1 beyond."},
    Command{"new", "[TEMPLATE] [-o FILE]", "write a commented starter scene", Operands::starter, new_options,
            ""},
};

} // namespace

std::span<const Command> commands() { return command_table; }

const Command* find_command(const std::string& name) {
    const auto found = std::find_if(command_table.begin(), command_table.end(),
                                    [&](const Command& command) { return command.name == name; });
    return found == command_table.end() ? nullptr : &*found;
}

std::vector<std::string> command_names() {
    std::vector<std::string> names;
    for (const Command& command : command_table) names.emplace_back(command.name);
    return names;
}

std::string key(const Option& option) { return *option.name ? option.name : std::string(1, option.letter); }

std::string spelling(const Option& option) {
    return *option.name ? std::string("--") + option.name : std::string("-") + option.letter;
}

std::vector<std::string> spellings(const Option& option) {
    std::vector<std::string> all;
    if (option.letter) all.push_back(std::string("-") + option.letter);
    if (*option.name) all.push_back(std::string("--") + option.name);
    return all;
}

std::vector<std::string> spellings(const Command& command) {
    std::vector<std::string> all;
    for (const Option& option : command.options)
        for (std::string& name : spellings(option)) all.push_back(std::move(name));
    return all;
}

std::vector<std::string> choices(const Option& option) {
    const std::string value = option.value;
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (value.empty() || std::any_of(value.begin(), value.end(), is_capital)) return {};
    return split(value, '|');
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

} // namespace glint::cli
