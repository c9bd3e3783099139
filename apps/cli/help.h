#pragma once
// The texts of --help, from the table of options.

#include "options.h"

#include <string>

namespace glint::cli {

/// `glint --help`: the commands and the common options.
std::string top_help();
/// `glint COMMAND --help`: all options.
std::string command_help(const Command& command);

} // namespace glint::cli
