#pragma once
// The program, from its arguments to its exit code.

#include <string>
#include <vector>

namespace glint::viewer {

/// Opens the window and returns once it is closed. Exit codes are those of glint: 0 closed, 2 wrong usage,
/// 3 the file cannot be read, 4 a file cannot be written, 5 out of memory, 7 no display, 70 a defect.
int run(const std::vector<std::string>& arguments) noexcept;

} // namespace glint::viewer
