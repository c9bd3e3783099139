// Runs the window and maps errors to exit codes.
#include "run.h"

#include "app.h"

#include "glint/render.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

namespace glint::viewer {
namespace {

int exit_code(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::usage:
        return 2;
    case ErrorKind::input:
        return 3;
    case ErrorKind::output:
        return 4;
    case ErrorKind::resource:
        return 5;
    case ErrorKind::device:
        return 7;
    case ErrorKind::cancelled:
    case ErrorKind::internal:
        break;
    }
    return 70;
}

/// Ends the program without waiting for its threads: a driver that compiles a shader takes seconds and cannot
/// be interrupted. Files are written on this thread, so all of them are complete.
[[noreturn]] void exit_now() {
    std::cout.flush();
    std::_Exit(0);
}

int open(const std::vector<std::string>& arguments) {
    const Arguments options = parse_arguments(arguments);
    if (options.help) {
        std::cout << help_text();
    } else if (options.version) {
        std::cout << "glint-view " << version() << "\n";
    } else {
        App app(options);
        app.run();
        if (options.statistics) std::cout << app.statistics();
        exit_now();
    }
    return 0;
}

} // namespace

int run(const std::vector<std::string>& arguments) noexcept {
    try {
        return open(arguments);
    } catch (const Error& error) {
        // Without a display one line is enough.
        for (const Diagnostic& diagnostic : error.diagnostics())
            std::cerr << (error.kind() == ErrorKind::device
                              ? "error: " + diagnostic.message + "; " + diagnostic.hint
                              : to_string(diagnostic))
                      << "\n";
        return exit_code(error.kind());
    } catch (const std::bad_alloc&) {
        std::cerr << "error: out of memory\n";
        return 5;
    } catch (const std::exception& defect) {
        std::cerr << "error: " << defect.what() << " (a defect of glint-view: please report it)\n";
        return 70;
    }
}

} // namespace glint::viewer
