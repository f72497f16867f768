// The live window: pan, turn and zoom with the mouse; home key for the view from above.
#pragma once

#include <functional>
#include <stdexcept>

#include "modules/viewer/viewer_scene.h"

namespace regista {

struct WindowError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct WindowTask {
  std::function<void()> between_frames;  ///< must not block; what it throws ends the window and is rethrown
  std::function<ViewerScene()> scene;    ///< what to draw now
  std::function<bool()> stopped;         ///< true closes the window
};

/// Shows the scenes until the window is closed. Main thread only. Throws WindowError where there is no display.
void show_window(const WindowTask& task, int width_px, int height_px);

/// Throws WindowError when the environment names no display.
void require_display();

}  // namespace regista
