#pragma once
// How the programs end if memory is lacking.

namespace glint {

/// Writes "error: out of memory" to stderr, without using memory.
void report_out_of_memory() noexcept;

/// From here on, an operator new that fails ends the program with a message and exit_code::resource, and
/// leaves no temporary file. For programs that have nothing to save: so no library on the way can take the
/// exception for a damaged file, drop it, or wait for a thread that it ended.
void end_where_memory_is_lacking() noexcept;

/// The same only for a std::bad_alloc that nothing catches, as in a destructor or a thread.
void end_if_bad_alloc_is_uncaught() noexcept;

} // namespace glint
