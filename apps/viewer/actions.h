#pragma once
// What the actions of keys and buttons do.

#include "shortcuts.h"

namespace glint::viewer {

class CameraDriver;
class FileSaver;
class Messages;
class PixelInspector;
class Playback;
class SidePanel;
class Activity;
class Window;
class Workbench;
struct ViewState;

/// The parts of the window that actions work on.
struct ActionTargets {
    Window& window;
    Workbench& bench;
    ViewState& state;
    Activity& activity;
    Messages& messages;
    SidePanel& panel;
    Playback& playback;
    CameraDriver& camera;
    PixelInspector& inspector;
    FileSaver& saver;
};

/// Performs an action, unless it needs a scene and there is none. Changes of the view state have yet to be
/// passed on to the session: see apply().
void perform(Action action, ActionTargets& targets);

} // namespace glint::viewer
