// Lines and columns of --help.
#include "help.h"

#include "glint/render.h"

#include <fmt/format.h>

namespace glint::cli {
namespace {

constexpr int help_column = 39;

/// Options that share a line.
using Row = std::vector<const Option*>;

std::vector<Row> rows(const Command& command) {
    std::vector<Row> all;
    for (const Option& option : command.options) {
        if (!option.joined || all.empty()) all.emplace_back();
        all.back().push_back(&option);
    }
    return all;
}

/// "-o, --output FILE" with its help; options that share a line in their shortest spelling.
std::string line(const Row& row) {
    std::string left;
    std::string right;
    for (const Option* option : row) {
        const std::vector<std::string> names = spellings(*option);
        left += left.empty() ? "" : ", ";
        left += row.size() > 1 ? names.front() : fmt::format("{}", fmt::join(names, ", "));
        if (*option->value) left += std::string(" ") + option->value;
        right += (right.empty() ? "" : "; ") + std::string(option->help);
    }
    // Long names are aligned, with or without a letter before them.
    const char* indent = row.front()->letter ? "  " : "      ";
    return fmt::format("{:<{}} {}\n", indent + left, help_column - 1, right);
}

} // namespace

std::string top_help() {
    std::string text = fmt::format("glint {}, a ray tracer\n\n", version());
    text += "usage: glint FILE [-o OUT] [options]     render a scene (.toml) or a mesh\n"
            "       glint COMMAND ...\n\ncommands:\n";
    for (const Command& command : commands())
        text += fmt::format("  {:<{}}{}\n", fmt::format("{} {}", command.name, command.synopsis),
                            help_column - 2, command.summary);
    text += "\noptions of render used most:\n";
    for (const Option& option : commands().front().options)
        if (option.common) text += line({&option});
    text += fmt::format("\n  {:<{}}{}\n", "-h, --help; --version", help_column - 2,
                        "glint COMMAND --help lists all options of a command");
    return text;
}

std::string command_help(const Command& command) {
    std::string text =
        fmt::format("usage: glint {} {} [options]     {}\n", command.name, command.synopsis, command.summary);
    for (const Row& row : rows(command)) text += line(row);
    return text + command.notes + (*command.notes ? "\n" : "");
}

} // namespace glint::cli
