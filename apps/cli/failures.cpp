#include "failures.h"

#include "commands.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>

namespace glint::cli {
namespace {

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
