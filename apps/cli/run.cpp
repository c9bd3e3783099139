#include "run.h"

#include "commands.h"
#include "help.h"

#include "glint/render.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>

namespace glint::cli {
namespace {

/// A word that names no file and looks like none was meant for a command.
void refuse_unknown_command(const std::string& word) {
    const bool like_a_file =
        word.empty() || word.find_first_of("./") != std::string::npos || word.front() == '-';
    if (like_a_file || std::filesystem::exists(word)) return;
    const auto near = nearest_name(word, command_names());
    throw Error(ErrorKind::usage, fmt::format("\"{}\" is neither a command nor a file", word),
                near ? fmt::format("did you mean \"{}\"?", *near) : "glint --help lists the commands");
}

Console console_for(const Arguments& arguments) {
    const Verbosity verbosity = arguments.has("quiet")     ? Verbosity::quiet
                                : arguments.has("verbose") ? Verbosity::verbose
                                                           : Verbosity::normal;
    return {verbosity, wants_color(arguments.text("color").value_or("auto"))};
}

int call(const Arguments& arguments, Console& console) {
    const std::string name = arguments.command().name;
    if (name == "render") return render_command(arguments, console);
    if (name == "view") return view_command(arguments, console);
    if (name == "check") return check_command(arguments, console);
    if (name == "info") return info_command(arguments, console);
    if (name == "diff") return diff_command(arguments, console);
    if (name == "explain") return explain_command(arguments, console);
    if (name == "new") return new_command(arguments, console);
    throw Error(ErrorKind::internal, "no program for the command " + name);
}

int code_of(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::usage:
        return exit_code::usage;
    case ErrorKind::input:
        return exit_code::input;
    case ErrorKind::output:
        return exit_code::output;
    case ErrorKind::resource:
        return exit_code::resource;
    case ErrorKind::device:
        return exit_code::device;
    case ErrorKind::cancelled: // nothing that can be cancelled this way is asked to be
    case ErrorKind::internal:
        break;
    }
    return exit_code::internal;
}

/// Runs the command and turns every failure into a message and an exit code.
template <typename Work>
int guarded(Console& console, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) console.error(diagnostic);
        return code_of(error.kind());
    } catch (const std::bad_alloc&) {
        console.error("out of memory");
        return exit_code::resource;
    } catch (const std::length_error&) {
        console.error("out of memory");
        return exit_code::resource;
    } catch (const std::exception& defect) {
        console.error(fmt::format("internal error: {}", defect.what()),
                      "this is a defect of glint: please report it");
        return exit_code::internal;
    }
}

int dispatch(const std::vector<std::string>& words) {
    const bool named = !words.empty() && find_command(words.front());
    const Command& command = named ? *find_command(words.front()) : commands().front();
    if (words.empty()) throw Error(ErrorKind::usage, "no scene given", "glint --help shows how it is used");
    if (!named) refuse_unknown_command(words.front());
    if (!named && words.front() == "--version") {
        print_data(fmt::format("glint {}\n", version()));
        return exit_code::done;
    }
    const Arguments arguments = parse_arguments(command, {words.begin() + (named ? 1 : 0), words.end()});
    if (arguments.has("help")) {
        print_data(named ? command_help(command) : top_help());
        return exit_code::done;
    }
    Console console = console_for(arguments);
    return guarded(console, [&] { return call(arguments, console); });
}

} // namespace

int run(const std::vector<std::string>& words) noexcept {
    // Faults of the command line itself come before --color is known.
    Console console(Verbosity::normal, wants_color("auto"));
    return guarded(console, [&] { return dispatch(words); });
}

} // namespace glint::cli
