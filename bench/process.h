#pragma once
// Child processes, for measurements that must start cold.

#include <string>
#include <vector>

namespace glint::bench {

/// Runs this program with other arguments and returns its standard output. Throws std::runtime_error if its
/// exit status is not 0.
std::string run_self(const std::vector<std::string>& arguments);

} // namespace glint::bench
