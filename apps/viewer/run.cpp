#include "run.h"

#include "app.h"

#include "glint/render.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

namespace glint::viewer {
namespace {

int code_of(ErrorKind kind) {
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

/// Ends the program without waiting for its threads. A driver that compiles a shader cannot be interrupted,
/// and takes seconds. All files that were asked for are written by then, whole, on this thread.
[[noreturn]] void leave() {
    std::cout.flush();
    std::_Exit(0);
}

int open(const std::vector<std::string>& words) {
    const Arguments arguments = parse_arguments(words);
    if (arguments.help) {
        std::cout << help_text();
    } else if (arguments.version) {
        std::cout << "glint-view " << version() << "\n";
    } else {
        App app(arguments);
        app.run();
        if (arguments.statistics) std::cout << app.statistics();
        leave();
    }
    return 0;
}

} // namespace

int run(const std::vector<std::string>& words) noexcept {
    try {
        return open(words);
    } catch (const Error& error) {
        // Without a display there is one line to say.
        for (const Diagnostic& diagnostic : error.diagnostics())
            std::cerr << (error.kind() == ErrorKind::device
                              ? "error: " + diagnostic.message + "; " + diagnostic.hint
                              : to_string(diagnostic))
                      << "\n";
        return code_of(error.kind());
    } catch (const std::bad_alloc&) {
        std::cerr << "error: out of memory\n";
        return 5;
    } catch (const std::exception& defect) {
        std::cerr << "error: " << defect.what() << " (a defect of glint-view: please report it)\n";
        return 70;
    }
}

} // namespace glint::viewer
