#include "modules/viewer/scene_builder.h"

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfTriangles.h>

#include <cstdlib>

#include "modules/viewer/scene_drawing.h"

namespace regista {
namespace {

using mrpt::opengl::COpenGLScene;
using mrpt::opengl::CSetOfTriangles;

mrpt::img::TColorf to_mrpt(Color color) {
  return mrpt::img::TColorf(mrpt::img::TColor(color.red, color.green, color.blue));
}

CSetOfTriangles::Ptr to_mrpt(const Drawing& drawing) {
  std::vector<mrpt::opengl::TTriangle> triangles;
  triangles.reserve(drawing.size());
  for (const Triangle& triangle : drawing) {
    const auto point = [&](std::size_t i) {
      return mrpt::math::TPoint3Df(triangle.corners[i][0], triangle.corners[i][1], triangle.corners[i][2]);
    };
    mrpt::opengl::TTriangle& out = triangles.emplace_back(point(0), point(1), point(2));
    out.setColor(mrpt::img::TColor(triangle.color.red, triangle.color.green, triangle.color.blue));
  }
  auto object = CSetOfTriangles::Create();
  object->enableLight(false);
  object->insertTriangles(triangles);
  return object;
}

/// Puts the object in the place of the one with its name.
void replace(COpenGLScene& target, const std::string& name, const CSetOfTriangles::Ptr& object) {
  if (const auto old = target.getByName(name)) target.removeObject(old);
  object->setName(name);
  target.insert(object);
}

constexpr double kLineSpacing = 1.7;
// MRPT's monospaced letters are as wide as this share of their nominal height.
constexpr double kLetterWidth = 0.93;

void put_text(COpenGLScene& target, const ViewerScene& scene, double text_px) {
  auto viewport = target.getViewport();
  viewport->clearTextMessages();
  mrpt::opengl::TFontParams font;
  font.vfont_name = "mono";
  font.vfont_scale = static_cast<float>(text_px);
  font.vfont_kerning = 0.0;
  std::size_t id = 0;
  const auto put = [&](const std::vector<TextLine>& lines, bool right) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].text.empty()) continue;
      font.color = to_mrpt(lines[i].color);
      const double width = static_cast<double>(lines[i].text.size()) * kLetterWidth * text_px;
      const double x = right ? -(width + text_px) : text_px;
      viewport->addTextMessage(x, -kLineSpacing * text_px * static_cast<double>(i + 1), lines[i].text, id++, font);
    }
  };
  put(team_lines(scene), false);
  put(state_lines(scene), true);
}

}  // namespace

void fill_scene(COpenGLScene& target, const ViewerScene& scene, double text_px) {
  target.getViewport()->setCustomBackgroundColor(to_mrpt(palette::kSurroundings));
  replace(target, "field", to_mrpt(draw_field(scene.field)));
  replace(target, "play", to_mrpt(draw_play(scene)));
  put_text(target, scene, text_px);
}

void set_camera(COpenGLScene& target, const View& view) {
  mrpt::opengl::CCamera& camera = target.getViewport()->getCamera();
  camera.setOrthogonal();
  camera.setAzimuthDegrees(-90.0f);
  camera.setElevationDegrees(90.0f);
  camera.setZoomDistance(static_cast<float>(zoom_distance_m(view)));
  camera.setPointingAt(static_cast<float>(view.centre_m.x()), static_cast<float>(view.centre_m.y()), 0.0f);
  set_depth_range(target, zoom_distance_m(view));
}

double zoom_distance_m(const View& view) { return 2.0 * view.short_side_m; }

void set_depth_range(COpenGLScene& target, double distance_m) {
  target.getViewport()->setViewportClipDistances(static_cast<float>(0.1 * distance_m),
                                                 static_cast<float>(2.0 * distance_m));
}

double text_height_px(int width_px, int height_px) {
  // Two lines fit above the field; the longest two texts, left and right, fit side by side.
  constexpr double kPictureHeights = 72.0;
  constexpr double kLettersAcross = 125.0;
  return std::min(height_px / kPictureHeights, width_px / (kLettersAcross * kLetterWidth));
}

void prefer_exact_software_rendering() {
  constexpr int kKeepWhatTheUserSet = 0;
  setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", kKeepWhatTheUserSet);
}

}  // namespace regista
