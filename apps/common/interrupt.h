#pragma once
// SIGINT (Ctrl-C), SIGTERM and SIGHUP. They end the program and leave no temporary file. While `glint`
// renders frames the first one stops at the next tiles instead; the second one, or a second of time, ends the
// program.

#include "glint/scene.h"

namespace glint {

/// Writing to a pipe that nobody reads, or beyond the limit on the size of files, fails with an error instead
/// of ending the program.
void report_failing_writes();
/// Installs the handlers.
void watch_signals();
/// From now on the first signal only sets the flag, and the program has a second to end.
void stop_gently();
/// After the first signal: what is written now may take longer. A second signal ends the program.
void take_time();
/// Set by the first signal; for RenderOptions::cancel.
const CancelFlag& cancel_flag();
/// The exit code after a signal, 128 + its number; 0 without one.
int stopped_by();

} // namespace glint
