// The only file that sees CLI11, which is slow to compile. It splits words into options, values and operands;
// what they mean is read by Arguments.
#include "arguments.h"

#include "glint/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace glint::cli {
namespace {

std::vector<std::string> all_spellings(const Command& command) {
    std::vector<std::string> all;
    for (const Option& option : command.options)
        for (std::string& name : spellings(option)) all.push_back(std::move(name));
    return all;
}

std::string help_hint(const Command& command) { return fmt::format("see glint {} --help", command.name); }

/// CLI11 gives what it did not understand of "-size" as "-ize": the word as it was typed.
std::string as_typed(const std::string& rest, const std::vector<std::string>& words) {
    if (rest.rfind("--", 0) == 0 || rest.size() < 2) return rest;
    for (const std::string& word : words) {
        const std::string tail = rest.substr(1);
        if (word.size() < tail.size() || word[0] != '-') continue;
        if (word.compare(word.size() - tail.size(), tail.size(), tail) == 0) return word;
    }
    return rest;
}

[[noreturn]] void refuse_unknown(const Command& command, const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    std::vector<std::string> long_names;
    for (const Option& option : command.options)
        if (*option.name) long_names.emplace_back(option.name);
    // Without dashes, so that "-size" is near to "--size" and "--time" is not.
    const std::string bare = name.substr(std::min(name.find_first_not_of('-'), name.size()));
    const auto near = bare.size() > 1 ? nearest_name(bare, long_names) : std::nullopt;
    throw Error(ErrorKind::usage, fmt::format("unknown option \"{}\"", name),
                near ? fmt::format("did you mean \"--{}\"?", *near) : help_hint(command));
}

void check_value(const Command& command, const Option& option, const std::string& value) {
    const std::vector<std::string> names = all_spellings(command);
    if (std::find(names.begin(), names.end(), value) != names.end() || value.empty())
        throw Error(ErrorKind::usage, fmt::format("{} needs a value: {}", spelling(option), option.value),
                    value.empty() ? "" : fmt::format("\"{}\" after it is an option", value));
    const std::vector<std::string> allowed = choices(option);
    if (allowed.empty() || std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return;
    const auto near = nearest_name(value, allowed);
    throw Error(ErrorKind::usage, fmt::format("{} \"{}\" is not valid", spelling(option), value),
                fmt::format("expected {}", fmt::join(allowed, ", ")) +
                    (near ? fmt::format("; did you mean \"{}\"?", *near) : ""));
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
        // A command's name behind an option would otherwise be taken for a scene.
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

/// CLI11 takes whatever follows for the value, so one is missing only after the last word.
[[noreturn]] void refuse_missing_value(const Command& command, const std::string& last) {
    for (const Option& option : command.options)
        for (const std::string& name : spellings(option))
            if (name == last)
                throw Error(ErrorKind::usage, fmt::format("{} needs a value: {}", name, option.value),
                            option.help);
    throw Error(ErrorKind::usage, fmt::format("\"{}\" is not understood", last), help_hint(command));
}

} // namespace

Arguments parse_arguments(const Command& command, const std::vector<std::string>& words) {
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    std::map<std::string, std::vector<std::string>> values;
    std::map<std::string, bool> flags;
    for (const Option& option : command.options) {
        const std::string names = fmt::format("{}", fmt::join(spellings(option), ","));
        if (*option.value) {
            app.add_option(names, values[key(option)])->allow_extra_args(false);
        } else {
            app.add_flag(names, flags[key(option)])->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
        }
    }
    std::vector<std::string> operands;
    app.add_option("operands", operands);

    try {
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::ArgumentMismatch&) {
        refuse_missing_value(command, words.back());
    } catch (const CLI::ParseError& fault) {
        throw Error(ErrorKind::usage, fault.what(), help_hint(command));
    }
    for (const std::string& rest : app.remaining())
        if (rest != "--") refuse_unknown(command, as_typed(rest, words));

    for (const Option& option : command.options) {
        auto& given = values[key(option)];
        for (const std::string& value : given) check_value(command, option, value);
        if (flags[key(option)]) given.emplace_back();
        if (given.empty()) values.erase(key(option));
    }
    // Devices are no matter of a file.
    const bool needs_operands = !values.count("help") && !values.count("devices");
    if (needs_operands) check_operands(command, operands);
    return {command, std::move(values), std::move(operands)};
}

} // namespace glint::cli
