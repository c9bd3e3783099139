#include "failures.h"

#include "commands.h"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace glint::cli {
namespace {

/// Nothing is cancelled in a way that ends here.
int code_of(ErrorKind kind) {
    return kind == ErrorKind::usage      ? exit_code::usage
           : kind == ErrorKind::input    ? exit_code::input
           : kind == ErrorKind::output   ? exit_code::output
           : kind == ErrorKind::resource ? exit_code::resource
           : kind == ErrorKind::device   ? exit_code::device
                                         : exit_code::internal;
}

int report_defect(Console& console, const std::exception& defect) {
    console.error(fmt::format("internal error: {}", defect.what()),
                  "this is a defect of glint: please report it");
    return exit_code::internal;
}

/// Uses no memory. Not by stdio, whose buffer may have to be allocated.
void report_out_of_memory() {
    constexpr std::string_view text = "glint: error: out of memory\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

int report_and_classify(Console& console) {
    try {
        throw;
    } catch (const Error& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) console.error(diagnostic);
        return code_of(error.kind());
    } catch (const std::bad_alloc&) {
        console.error("out of memory");
        return exit_code::resource;
    } catch (const std::system_error& refused) {
        if (refused.code() != std::errc::resource_unavailable_try_again)
            return report_defect(console, refused);
        console.error("the system starts no more threads", "end other programs, or use fewer --threads");
        return exit_code::resource;
    } catch (const std::length_error& limit) {
        // A limit of the library ("too many triangles"), or of a container.
        console.error(limit.what(), "this is more than glint can hold");
        return exit_code::resource;
    } catch (const std::exception& defect) {
        return report_defect(console, defect);
    }
}

} // namespace

int report_failure(Console& console) noexcept {
    try {
        return report_and_classify(console);
    } catch (...) {
        // Not even the message found memory.
        report_out_of_memory();
        return exit_code::resource;
    }
}

void end_without_memory_if_uncaught() {
    std::set_terminate([] {
        // What a destructor, a thread or a function that must not throw let go.
        try {
            if (std::current_exception()) throw;
        } catch (const std::bad_alloc&) {
            report_out_of_memory();
            std::_Exit(exit_code::resource);
        } catch (...) {
        }
        std::abort();
    });
}

} // namespace glint::cli
