// A ViewerScene as an MRPT scene: one builder for the window, the offscreen pictures and the recording, so that all
// show the same. Only its .cc, and those of the three, see MRPT.
#pragma once

#include "modules/viewer/view.h"
#include "modules/viewer/viewer_scene.h"

namespace mrpt::opengl {
class COpenGLScene;
}

namespace regista {

/// Draws the scene into `target`, replacing what an earlier call drew there. Text is `text_px` pixels high.
void fill_scene(mrpt::opengl::COpenGLScene& target, const ViewerScene& scene, double text_px);

/// Points the scene's own camera straight down at the view.
void set_camera(mrpt::opengl::COpenGLScene& target, const View& view);

/// MRPT's measure of zoom for a view: an orthogonal camera shows half its distance along the shorter side.
double zoom_distance_m(const View& view);

/// Near and far planes for a camera at that distance. A short range, because depth may be of half precision.
void set_depth_range(mrpt::opengl::COpenGLScene& target, double distance_m);

/// Height of text that suits a picture of that size.
double text_height_px(int width_px, int height_px);

/// Call it before the first drawing, while the process has one thread. Mesa's software renderer otherwise computes
/// vertices in half precision, where thin layers and text vanish; real graphics cards ignore the setting, and one that
/// the user has made stands.
void prefer_exact_software_rendering();

}  // namespace regista
