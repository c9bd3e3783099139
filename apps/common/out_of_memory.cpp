#include "out_of_memory.h"

#include "exit_code.h"

#include "glint/write_file.h"

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <unistd.h>

namespace glint {
namespace {

[[noreturn]] void end() {
    report_out_of_memory();
    remove_temporary_files();
    std::_Exit(exit_code::resource);
}

} // namespace

void report_out_of_memory() noexcept {
    // Not by stdio, whose buffer may have to be allocated.
    constexpr std::string_view text = "error: out of memory\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

void end_where_memory_is_lacking() noexcept { std::set_new_handler(end); }

void end_if_bad_alloc_is_uncaught() noexcept {
    std::set_terminate([] {
        try {
            if (std::current_exception()) throw;
        } catch (const std::bad_alloc&) {
            end();
        } catch (...) {
        }
        std::abort();
    });
}

} // namespace glint
