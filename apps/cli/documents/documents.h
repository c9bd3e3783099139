#pragma once
// What is installed beside the command, written from the same table of options that it parses by.

#include <string>

namespace glint::cli {

/// glint.1, roff.
std::string man_page(const std::string& version);

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

} // namespace glint::cli
