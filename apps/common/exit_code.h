#pragma once
// The exit codes of glint and glint-view.

#include "glint/error.h"

namespace glint::exit_code {

inline constexpr int done = 0;
inline constexpr int differ = 1;   ///< pictures differ
inline constexpr int usage = 2;    ///< wrong command line
inline constexpr int input = 3;    ///< input invalid or unreadable
inline constexpr int output = 4;   ///< output cannot be written
inline constexpr int resource = 5; ///< out of memory or beyond a size limit
inline constexpr int device = 7;   ///< a device is missing or lost
inline constexpr int internal = 70;

/// The code for an Error.
constexpr int of(ErrorKind kind) {
    return kind == ErrorKind::usage      ? usage
           : kind == ErrorKind::input    ? input
           : kind == ErrorKind::output   ? output
           : kind == ErrorKind::resource ? resource
           : kind == ErrorKind::device   ? device
                                         : internal;
}

} // namespace glint::exit_code
