#pragma once
// The commands. Each takes a checked command line and returns the exit code, which is 128 + a signal's number
// if one stopped it; run() prints thrown Errors.

#include "../common/exit_code.h"
#include "arguments.h"
#include "console.h"

namespace glint::cli {

int render_command(const Arguments& arguments, Console& console);
int view_command(const Arguments& arguments, Console& console);
int check_command(const Arguments& arguments, Console& console);
int info_command(const Arguments& arguments, Console& console);
int diff_command(const Arguments& arguments, Console& console);
int explain_command(const Arguments& arguments, Console& console);
int new_command(const Arguments& arguments, Console& console);

} // namespace glint::cli
