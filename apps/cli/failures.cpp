#include "failures.h"

#include "commands.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>

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

} // namespace

int report_failure(Console& console) {
    try {
        throw;
    } catch (const Error& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) console.error(diagnostic);
        return code_of(error.kind());
    } catch (const std::bad_alloc&) {
        console.error("out of memory");
        return exit_code::resource;
    } catch (const std::length_error& limit) {
        // A limit of the library ("too many triangles"), or of a container.
        console.error(limit.what(), "this is more than glint can hold");
        return exit_code::resource;
    } catch (const std::exception& defect) {
        console.error(fmt::format("internal error: {}", defect.what()),
                      "this is a defect of glint: please report it");
        return exit_code::internal;
    }
}

} // namespace glint::cli
