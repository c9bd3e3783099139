// Passes the view state on to the session.
#include "view_state.h"

#include "session/session.h"

namespace glint::viewer {

bool apply(const ViewState& state, Session& session) {
    const bool changed = session.show() != state.show || session.kernel() != state.kernel;
    for (const ViewSlot slot : view_slots) session.set_show(state.show, slot);
    session.set_kernel(state.kernel);
    session.set_tone(state.view);
    return changed;
}

} // namespace glint::viewer
