// The man page in roff.
#include "generate_docs.h"

#include "../options.h"

#include <fmt/format.h>

namespace glint::cli {
namespace {

constexpr const char* description = R"(.SH DESCRIPTION
.B glint
renders a scene file (.toml, see the reference of scene files) or a bare mesh, which it frames and lights, to a
picture.
Scenes are TOML; \- reads one from standard input.
Pixel (0, 0) is top left.
The picture depends on scene and settings alone, not on threads or tiles.
Standard output carries data only; messages, progress and the closing line go to standard error.
)";

constexpr const char* closing = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
the pictures differ (diff)
.TP
.B 2
wrong usage
.TP
.B 3
input is invalid or cannot be read
.TP
.B 4
output cannot be written
.TP
.B 5
out of a resource: memory, a size limit
.TP
.B 7
a device is missing or lost
.TP
.B 70
a defect of glint
.TP
.BR 130 ", " 143
stopped by SIGINT (Ctrl\-C) or SIGTERM.
The first one stops a render at the next tiles and writes nothing, or with
.B \-\-keep\-partial
what there is; the second one stops it at once.
.SH ENVIRONMENT
.TP
.B NO_COLOR
where set and not empty, messages have no colours
.TP
.B TERM
where unset or "dumb", there are neither colours nor a progress bar
.SH EXAMPLES
.nf
glint new glass \-o scene.toml
glint scene.toml
glint dragon.ply \-\-size 1280x720 \-o dragon.png
glint scene.toml \-D material.glass.index=1.33 \-o water.exr \-\-layers
glint diff before.png after.png \-\-metric mae \-\-tolerance 0.02
.fi
)";

/// Escapes the characters that roff interprets.
std::string literal(const std::string& text) {
    std::string safe;
    bool line_start = true;
    for (const char c : text) {
        if (line_start && (c == '.' || c == '\'')) safe += "\\&";
        if (c == '-')
            safe += "\\-";
        else if (c == '\\')
            safe += "\\e";
        else
            safe += c;
        line_start = c == '\n';
    }
    return safe;
}

std::string entry(const Option& option) {
    const std::string names = fmt::format("\\fB{}\\fR", fmt::join(spellings(option), "\\fR, \\fB"));
    std::string shown;
    for (const char c : names) shown += c == '-' ? "\\-" : std::string(1, c);
    const std::string value = *option.value ? " \\fI" + literal(option.value) + "\\fR" : "";
    return fmt::format(".TP\n{}{}\n{}\n", shown, value, literal(option.help));
}

std::string section(const Command& command) {
    std::string text = fmt::format(".SS glint {} {}\n{}.\n", command.name, literal(command.synopsis),
                                   literal(command.summary));
    for (const Option& option : command.options) text += entry(option);
    if (*command.notes) text += fmt::format(".PP\n.nf\n{}\n.fi\n", literal(command.notes));
    return text;
}

} // namespace

std::string man_page(const std::string& version) {
    std::string text = fmt::format(".TH GLINT 1 \"\" \"glint {}\" \"User commands\"\n", version);
    text += ".SH NAME\nglint \\- a ray tracer: from a scene or a mesh to a picture\n.SH SYNOPSIS\n";
    text += ".B glint\n.I FILE\n[\\fB\\-o\\fR \\fIOUT\\fR] [options]\n";
    for (const Command& command : commands())
        text += fmt::format(".br\n.B glint {}\n{}\n", command.name, literal(command.synopsis));
    text += description;
    text +=
        ".SH COMMANDS\nWithout a command, glint renders. A file named like a command is written ./render.\n";
    for (const Command& command : commands()) text += section(command);
    return text + closing;
}

} // namespace glint::cli
