#pragma once
// SIGINT (Ctrl-C) and SIGTERM. Before rendering starts they end the program, since there is nothing to save;
// after that the first one stops at the next tiles and the second one ends the program.

#include "glint/render.h"

namespace glint::cli {

/// Writing to a pipe that nobody reads, or beyond the limit on the size of files, fails with an error instead
/// of ending the program.
void report_failing_writes();
/// Installs the handlers of SIGINT and SIGTERM.
void watch_signals();
/// From now on the first signal only sets the flag.
void stop_gently();
/// From now on the first signal ends the program: while it may wait for a reader of its output.
void stop_at_once();
/// Set by the first signal; for RenderOptions::cancel.
const CancelFlag& cancel_flag();
/// The exit code after a signal, 128 + its number; 0 without one.
int stopped_by();

} // namespace glint::cli
