#pragma once
// Acts as another X11 program on the window's screen.

#include <string>

namespace glint::test {

/// Drops a file on the window (XDND). False if no window takes it within ten seconds.
bool drop_file(const std::string& display, const std::string& path);

/// The clipboard as text; empty if nothing arrives within ten seconds.
std::string clipboard(const std::string& display);

} // namespace glint::test
