#pragma once
// The commands. Each takes a checked command line and returns the exit code; run() prints thrown Errors.

#include "arguments.h"
#include "console.h"

namespace glint::cli {

/// Exit codes; a run stopped by a signal returns 128 + its number.
namespace exit_code {
inline constexpr int done = 0;
inline constexpr int differ = 1;   ///< pictures differ
inline constexpr int usage = 2;    ///< wrong command line
inline constexpr int input = 3;    ///< input invalid or unreadable
inline constexpr int output = 4;   ///< output cannot be written
inline constexpr int resource = 5; ///< out of memory or beyond a size limit
inline constexpr int device = 7;   ///< a device is missing or lost
inline constexpr int internal = 70;
} // namespace exit_code

int render_command(const Arguments& arguments, Console& console);
int view_command(const Arguments& arguments, Console& console);
int check_command(const Arguments& arguments, Console& console);
int info_command(const Arguments& arguments, Console& console);
int diff_command(const Arguments& arguments, Console& console);
int explain_command(const Arguments& arguments, Console& console);
int new_command(const Arguments& arguments, Console& console);

} // namespace glint::cli
