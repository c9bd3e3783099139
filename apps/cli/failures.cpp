#include "failures.h"

#include "../common/out_of_memory.h"
#include "commands.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

namespace glint::cli {
namespace {

int report_defect(Console& console, const std::exception& defect) {
    console.error(fmt::format("internal error: {}", defect.what()),
                  "this is a defect of glint: please report it");
    return exit_code::internal;
}

int report_and_classify(Console& console) {
    try {
        throw;
    } catch (const Error& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) console.error(diagnostic);
        return exit_code::of(error.kind());
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

} // namespace glint::cli
