#pragma once
// Another program on the window's screen, as far as windows of X can tell.

#include <string>

namespace glint::test {

/// Drags a file there and lets it fall (XDND). False where no window takes it within ten seconds.
bool drop_file(const std::string& display, const std::string& path);

/// What was copied last, as text; empty where nothing is or comes within ten seconds.
std::string clipboard(const std::string& display);

} // namespace glint::test
