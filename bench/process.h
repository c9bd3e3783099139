#pragma once
// What must not be warm from what was measured before runs in a process of its own.

#include <string>
#include <vector>

namespace glint::bench {

/// What this very program prints to standard output when it is run with these arguments. Throws
/// std::runtime_error where it does not end with 0.
std::string run_self(const std::vector<std::string>& arguments);

} // namespace glint::bench
