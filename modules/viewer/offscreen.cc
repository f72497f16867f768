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

constexpr int kStripColumns = 3;

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

/// Scenes side by side, row by row.
mrpt::img::CImage strip(std::span<const ViewerScene> scenes, int width_px, int height_px) {
  const int columns = std::min(static_cast<int>(scenes.size()), kStripColumns);
  const int rows = (static_cast<int>(scenes.size()) + columns - 1) / columns;
  mrpt::img::CImage all(static_cast<unsigned>(columns * width_px), static_cast<unsigned>(rows * height_px),
                        mrpt::img::CH_RGB);
  all.filledRectangle(0, 0, columns * width_px - 1, rows * height_px - 1, mrpt::img::TColor::white());
  for (int i = 0; i < static_cast<int>(scenes.size()); ++i) {
    const mrpt::img::CImage one = render(scenes[static_cast<std::size_t>(i)], width_px, height_px);
    all.drawImage(i % columns * width_px, i / columns * height_px, one);
  }
  return all;
}

void save(const mrpt::img::CImage& picture, const std::string& file) {
  bool written = false;
  try {
    written = picture.saveToFile(file);
  } catch (const std::exception&) {
    // Reported below: MRPT's text is a call stack.
  }
  if (!written)
    throw PictureError("cannot write the picture '" + file + "': the folder must exist, the name end in .png");
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

void write_picture(const ViewerScene& scene, const std::string& file, int width_px, int height_px) {
  write_strip({&scene, 1}, file, width_px, height_px);
}

void write_strip(std::span<const ViewerScene> scenes, const std::string& file, int width_px, int height_px) {
  mrpt::img::CImage picture;
  try {
    picture = scenes.size() == 1 ? render(scenes.front(), width_px, height_px) : strip(scenes, width_px, height_px);
  } catch (const std::exception& error) {
    throw PictureError("cannot draw offscreen: " + first_line(error.what()) + " (packages libegl1, libgl1-mesa-dri?)");
  }
  save(picture, file);
}

}  // namespace regista
