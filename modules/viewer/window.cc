#include "modules/viewer/window.h"

#include <mrpt/gui/CDisplayWindowGUI.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <optional>

#include "modules/viewer/scene_builder.h"

namespace regista {
namespace {

constexpr const char* kNoDisplay = "no display: set DISPLAY or use --snapshot FILE.png";

// 25 pictures a second at most; between them messages are taken in.
constexpr int kIdlePeriod_ms = 20;
constexpr int kRepaintPeriod_ms = 40;
constexpr auto kRedrawEvery = std::chrono::milliseconds(kRepaintPeriod_ms);

using Window = mrpt::gui::CDisplayWindowGUI;
using SteadyTime = std::chrono::steady_clock::time_point;

void look_from_above(Window& window, const ViewerScene& scene) {
  const View view = fitted_view(scene.field, window.width(), window.height());
  window.camera().setCameraProjective(false);
  window.camera().setAzimuthDegrees(-90.0f);
  window.camera().setElevationDegrees(90.0f);
  window.camera().setZoomDistance(static_cast<float>(zoom_distance_m(view)));
  window.camera().setCameraPointing(static_cast<float>(view.centre_m.x()), static_cast<float>(view.centre_m.y()), 0.0f);
}

void redraw(Window& window, const ViewerScene& scene) {
  const std::lock_guard lock(window.background_scene_mtx);
  fill_scene(*window.background_scene, scene, text_height_px(window.width(), window.height()));
  set_depth_range(*window.background_scene, window.camera().getZoomDistance());
}

/// What the loop callback keeps between calls.
struct Showing {
  Window& window;
  const WindowTask& task;
  SteadyTime drawn{};
  std::optional<FieldGeometry> fitted_field;
  std::exception_ptr thrown;

  void step() {
    task.between_frames();
    const SteadyTime now = std::chrono::steady_clock::now();
    if (now - drawn >= kRedrawEvery) {
      drawn = now;
      const ViewerScene scene = task.scene();
      if (fitted_field != scene.field) look_from_above(window, scene);
      fitted_field = scene.field;
      redraw(window, scene);
    }
    if (task.stopped()) close();
  }

  /// nanogui would print an exception and go on.
  void step_or_leave() {
    if (thrown) return;
    try {
      step();
    } catch (...) {
      thrown = std::current_exception();
      close();
    }
  }

  /// The main loop ends when no window is left. nanogui::leave() would end the thread that wakes that loop, which then
  /// sometimes sleeps on for ever.
  void close() { window.setVisible(false); }
};

void run(const WindowTask& task, int width_px, int height_px) {
  Window window("Regista", static_cast<unsigned>(width_px), static_cast<unsigned>(height_px));
  window.background_scene = mrpt::opengl::COpenGLScene::Create();
  Showing showing{window, task, {}, {}, {}};
  window.addKeyboardCallback([&](int key, int, int action, int) {
    if (key != GLFW_KEY_HOME || action != GLFW_PRESS) return false;
    showing.fitted_field.reset();
    return true;
  });
  showing.step_or_leave();  // so that the first picture is not empty
  window.addLoopCallback([&] { showing.step_or_leave(); });
  window.performLayout();
  window.drawAll();
  window.setVisible(true);
  if (!showing.thrown) nanogui::mainloop(kIdlePeriod_ms, kRepaintPeriod_ms);
  if (showing.thrown) std::rethrow_exception(showing.thrown);
}

}  // namespace

void require_display() {
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0') throw WindowError(kNoDisplay);
}

void show_window(const WindowTask& task, int width_px, int height_px) {
  require_display();
  prefer_exact_software_rendering();
  try {
    nanogui::init();
  } catch (const std::exception&) {
    throw WindowError(std::string(kNoDisplay) + " (cannot open '" + std::getenv("DISPLAY") + "')");
  }
  try {
    run(task, width_px, height_px);
  } catch (...) {
    nanogui::shutdown();
    throw;
  }
  nanogui::shutdown();
}

}  // namespace regista
