#pragma once
// Ctrl-C and SIGTERM. Before rendering starts they end the program at once, since nothing is to be saved;
// from then on the first one asks for a stop at tile boundaries and the second one ends the program.

#include "glint/render.h"

namespace glint::cli {

/// Installs the handlers.
void watch_signals();
/// From here on the first signal only raises the flag.
void stop_gently();
/// Raised by the first signal; for RenderOptions::cancel.
const CancelFlag& cancel_flag();
/// 128 + the signal that came, or 0: the exit code of a run that was stopped.
int stopped_by();

} // namespace glint::cli
