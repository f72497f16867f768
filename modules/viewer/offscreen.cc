#include "modules/viewer/offscreen.h"

#include <mrpt/img/CImage.h>
#include <mrpt/opengl/CFBORender.h>

#include "modules/viewer/scene_builder.h"

namespace regista {
namespace {

// Drawn larger and averaged down: the offscreen buffer has no antialiasing of its own. Beyond 8192 pixels a software
// renderer may refuse.
constexpr int kOversampling = 2;
constexpr int kLargestSide_px = 8192;

mrpt::img::CImage render(const ViewerScene& scene, int width_px, int height_px) {
  prefer_exact_software_rendering();
  mrpt::opengl::COpenGLScene target;
  const int factor = std::max(width_px, height_px) * kOversampling <= kLargestSide_px ? kOversampling : 1;
  const View view = fitted_view(scene.field, factor * width_px, factor * height_px);
  fill_scene(target, scene, factor * text_height_px(width_px, height_px));
  set_camera(target, view);
  mrpt::opengl::CFBORender renderer(static_cast<unsigned>(view.width_px), static_cast<unsigned>(view.height_px));
  renderer.setCamera(target, target.getViewport()->getCamera());
  mrpt::img::CImage large;
  renderer.render_RGB(target, large);
  if (factor == 1) return large;
  mrpt::img::CImage picture;
  large.scaleImage(picture, static_cast<unsigned>(width_px), static_cast<unsigned>(height_px),
                   mrpt::img::IMG_INTERP_AREA);
  return picture;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

void write_picture(const ViewerScene& scene, const std::string& file, int width_px, int height_px) {
  mrpt::img::CImage picture;
  try {
    picture = render(scene, width_px, height_px);
  } catch (const std::exception& error) {
    throw PictureError("cannot draw offscreen: " + first_line(error.what()) + " (packages libegl1, libgl1-mesa-dri?)");
  }
  bool written = false;
  try {
    written = picture.saveToFile(file);
  } catch (const std::exception&) {
    // Reported below: MRPT's text is a call stack.
  }
  if (!written)
    throw PictureError("cannot write the picture '" + file + "': the folder must exist, the name end in .png");
}

}  // namespace regista
