#pragma once
// From the words of the command line to the exit code.

#include <string>
#include <vector>

namespace glint::cli {

/// Runs the command that the words name; prints what goes wrong. Throws nothing.
int run(const std::vector<std::string>& words) noexcept;

} // namespace glint::cli
