#pragma once
// From exceptions to messages and exit codes.

#include "console.h"

namespace glint::cli {

/// Prints why the exception being handled was thrown, and returns the exit code. To be called in a catch
/// block. Also if no memory is left for the message.
int report_failure(Console& console) noexcept;

} // namespace glint::cli
