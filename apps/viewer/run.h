#pragma once
// The program from its words to its exit code.

#include <string>
#include <vector>

namespace glint::viewer {

/// Opens the window and returns when it is closed. The codes are those of glint: 0 closed, 2 wrong usage, 3
/// the file cannot be read, 4 a file cannot be written, 5 out of memory, 7 no display, 70 a defect.
int run(const std::vector<std::string>& words) noexcept;

} // namespace glint::viewer
