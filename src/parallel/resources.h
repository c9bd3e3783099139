#pragma once
// The processors and the memory that this process may use.

#include <limits>
#include <string>

namespace glint::parallel {

/// Limits of the control groups (cgroups, versions 1 and 2) of this process; infinite where there is none.
struct GroupLimits {
    double processors = std::numeric_limits<double>::infinity(); ///< time of so many
    double memory = std::numeric_limits<double>::infinity();     ///< bytes
};

/// The least limits of the groups that this process is in and of all above them. `root` is the folder of proc
/// and sys.
GroupLimits group_limits(const std::string& root = "");

/// Number of processors that this process may use, at least 1: by affinity and control groups.
int available_threads();

/// Bytes of memory that this process may use: those of the machine, or a smaller limit of control groups or
/// of ulimit.
double memory_limit();

/// Bytes of memory that this process holds; 0 if the system does not tell.
double resident_memory();

} // namespace glint::parallel
