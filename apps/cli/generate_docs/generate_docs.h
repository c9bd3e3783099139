#pragma once
// The man page and shell completions, generated from the table of options.

#include <string>

namespace glint::cli {

/// glint.1, roff.
std::string man_page(const std::string& version);

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

} // namespace glint::cli
