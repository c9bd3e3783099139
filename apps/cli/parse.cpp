// Splits arguments into options, values and operands. The only file that includes CLI11, which is slow to
// compile.
#include "arguments.h"

#include "glint/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace glint::cli {
namespace {

std::string help_hint(const Command& command) { return fmt::format("see glint {} --help", command.name); }

/// The argument as it was typed: CLI11 reports an unknown "-size" as "-ize".
std::string as_typed(const std::string& rest, const std::vector<std::string>& arguments) {
    if (rest.rfind("--", 0) == 0 || rest.size() < 2) return rest;
    for (const std::string& argument : arguments) {
        const std::string tail = rest.substr(1);
        if (argument.size() < tail.size() || argument[0] != '-') continue;
        if (argument.compare(argument.size() - tail.size(), tail.size(), tail) == 0) return argument;
    }
    return rest;
}

[[noreturn]] void refuse_unknown(const Command& command, const std::string& argument) {
    const std::string name = argument.substr(0, argument.find('='));
    std::vector<std::string> long_names;
    for (const Option& option : command.options)
        if (*option.name) long_names.emplace_back(option.name);
    // Dashes are left out, so that "-size" is near to "--size" and "--time" is not.
    const std::string bare = name.substr(std::min(name.find_first_not_of('-'), name.size()));
    const auto near = bare.size() > 1 ? nearest_name(bare, long_names) : std::nullopt;
    throw Error(ErrorKind::usage, fmt::format("unknown option \"{}\"", name),
                near ? fmt::format("did you mean \"--{}\"?", *near) : help_hint(command));
}

void check_value(const Command& command, const Option& option, const std::string& value) {
    const std::vector<std::string> names = spellings(command);
    if (std::find(names.begin(), names.end(), value) != names.end() || value.empty())
        throw Error(ErrorKind::usage, fmt::format("{} needs a value: {}", spelling(option), option.value),
                    value.empty() ? "" : fmt::format("\"{}\" after it is an option", value));
    const std::vector<std::string> allowed = choices(option);
    if (allowed.empty() || std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return;
    const std::string near = did_you_mean(value, allowed);
    throw Error(ErrorKind::usage, fmt::format("{} \"{}\" is not valid", spelling(option), value),
                fmt::format("expected {}", fmt::join(allowed, ", ")) + (near.empty() ? "" : "; " + near));
}

void check_operands(const Command& command, const std::vector<std::string>& operands) {
    const auto wrong = [&](const char* what) {
        throw Error(ErrorKind::usage, what,
                    fmt::format("usage: glint {} {}", command.name, command.synopsis));
    };
    if (std::find(operands.begin(), operands.end(), "") != operands.end()) wrong("a name is empty");
    const std::size_t count = operands.size();
    switch (command.operands) {
    case Operands::scene:
        if (count == 0) wrong("no scene given");
        // A command after an option would be taken for a scene.
        if (count > 1 && find_command(operands[0]))
            throw Error(ErrorKind::usage, fmt::format("\"{}\" comes too late", operands[0]),
                        fmt::format("the command comes first: glint {} ...", operands[0]));
        if (count > 1) wrong("more than one scene given");
        break;
    case Operands::maybe_scene:
        if (count > 1) wrong("more than one scene given");
        break;
    case Operands::scenes:
        if (count == 0) wrong("no scene given");
        break;
    case Operands::two_pictures:
        if (count != 2) wrong("two pictures are needed");
        break;
    case Operands::starter:
        if (count > 1) wrong("more than one template given");
        break;
    }
}

/// CLI11 takes any next argument as the value, so only the last option can lack one.
[[noreturn]] void refuse_missing_value(const Command& command, const std::string& last) {
    for (const Option& option : command.options)
        for (const std::string& name : spellings(option))
            if (name == last)
                throw Error(ErrorKind::usage, fmt::format("{} needs a value: {}", name, option.value),
                            option.help);
    throw Error(ErrorKind::usage, fmt::format("\"{}\" is not understood", last), help_hint(command));
}

/// CLI11 writes to `values` and `flags`, by key of the option.
void add_options(CLI::App& app, const Command& command,
                 std::map<std::string, std::vector<std::string>>& values,
                 std::map<std::string, bool>& flags) {
    for (const Option& option : command.options) {
        const std::string names = fmt::format("{}", fmt::join(spellings(option), ","));
        if (*option.value)
            app.add_option(names, values[key(option)])->allow_extra_args(false);
        else
            app.add_flag(names, flags[key(option)])->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    }
}

} // namespace

Arguments parse_arguments(const Command& command, const std::vector<std::string>& arguments) {
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    std::map<std::string, std::vector<std::string>> values;
    std::map<std::string, bool> flags;
    add_options(app, command, values, flags);
    std::vector<std::string> operands;
    app.add_option("operands", operands);

    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ArgumentMismatch&) {
        refuse_missing_value(command, arguments.back());
    } catch (const CLI::ParseError& fault) {
        throw Error(ErrorKind::usage, fault.what(), help_hint(command));
    }
    for (const std::string& rest : app.remaining())
        if (rest != "--") refuse_unknown(command, as_typed(rest, arguments));

    for (const Option& option : command.options) {
        auto& given = values[key(option)];
        for (const std::string& value : given) check_value(command, option, value);
        if (flags[key(option)]) given.emplace_back();
        if (given.empty()) values.erase(key(option));
    }
    // --devices needs no file.
    const bool needs_operands = !values.count("help") && !values.count("devices");
    if (needs_operands) check_operands(command, operands);
    return {command, std::move(values), std::move(operands)};
}

} // namespace glint::cli
