// The program `glint`: from the words of the command line to the exit code.
#include "../common/interrupt.h"
#include "../common/out_of_memory.h"
#include "commands.h"
#include "failures.h"
#include "help.h"

#include "glint/render.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace glint::cli {
namespace {

/// A word that names no file and looks like none was meant for a command.
void refuse_unknown_command(const std::string& word) {
    const bool like_a_file =
        word.empty() || word.find_first_of("./") != std::string::npos || word.front() == '-';
    std::error_code none;
    if (like_a_file || std::filesystem::exists(word, none)) return;
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

/// Runs the command and turns every failure into a message and an exit code.
template <typename Work>
int guarded(Console& console, const Work& work) {
    try {
        return work();
    } catch (...) {
        return report_failure(console);
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

/// Before the static objects of other sources are made, which takes memory.
struct EndsWhereMemoryIsLacking {
    EndsWhereMemoryIsLacking() {
        end_where_memory_is_lacking();
        end_if_bad_alloc_is_uncaught();
    }
};
[[gnu::init_priority(101)]] const EndsWhereMemoryIsLacking ends_where_memory_is_lacking;

/// Throws nothing.
int run(int argc, char** argv) noexcept {
    reserve_standard_streams();
    report_failing_writes();
    watch_signals();
    // Faults of the command line itself come before --color is known.
    Console console(Verbosity::normal, wants_color("auto"));
    return guarded(console, [&] { return dispatch({argv + 1, argv + argc}); });
}

} // namespace
} // namespace glint::cli

int main(int argc, char** argv) { return glint::cli::run(argc, argv); }
