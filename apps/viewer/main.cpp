// The program `glint-view`: runs the window and maps errors to exit codes.
#include "../common/exit_code.h"
#include "../common/interrupt.h"
#include "../common/out_of_memory.h"
#include "app.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

namespace glint::viewer {
namespace {

/// Ends the program without waiting for its threads: a driver that compiles a shader takes seconds and cannot
/// be interrupted. Files are written on this thread, so all of them are complete.
[[noreturn]] void exit_now(int code) {
    std::cout.flush();
    std::cerr.flush();
    std::_Exit(code);
}

void print(const std::vector<Diagnostic>& problems) {
    for (const Diagnostic& problem : problems) std::cerr << printable(to_string(problem), "\n\t") << "\n";
}

/// A window with nothing but the message that there is no such file would help nobody.
void require_file(const Arguments& arguments) {
    std::error_code unknown;
    if (arguments.file.empty() || std::filesystem::exists(arguments.file, unknown) || unknown) return;
    throw Error(ErrorKind::input, "there is no such file", {}, {.file = arguments.file});
}

int open(const std::vector<std::string>& words) {
    std::string text;
    const std::optional<Arguments> arguments = parse_arguments(words, text);
    if (arguments) {
        require_file(*arguments);
        App app(*arguments);
        app.run();
        if (arguments->statistics) std::cout << app.statistics.text();
        // A file that never became a scene is an error, also for those who only see the terminal.
        if (app.editor.description() == nullptr) print(app.editor.problems());
        exit_now(app.editor.description() == nullptr && !app.editor.problems().empty() ? 3 : 0);
    }
    std::cout << text;
    return 0;
}

int run(const std::vector<std::string>& words) noexcept {
    try {
        return open(words);
    } catch (const Error& error) {
        // Without a display one line is enough.
        for (const Diagnostic& diagnostic : error.diagnostics())
            std::cerr << (error.kind() == ErrorKind::device
                              ? "error: " + diagnostic.message + "; " + diagnostic.hint
                              : to_string(diagnostic))
                      << "\n";
        return exit_code::of(error.kind());
    } catch (const std::bad_alloc&) {
        report_out_of_memory();
        return exit_code::resource;
    } catch (const std::exception& defect) {
        std::cerr << "error: " << defect.what() << " (a defect of glint-view: please report it)\n";
        return exit_code::internal;
    }
}

} // namespace
} // namespace glint::viewer

int main(int argc, char** argv) {
    glint::report_failing_writes();
    glint::watch_signals();
    glint::end_if_bad_alloc_is_uncaught();
    return glint::viewer::run({argv + 1, argv + argc});
}
