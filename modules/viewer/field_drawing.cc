#include <algorithm>

#include "modules/viewer/layers.h"
#include "modules/viewer/scene_drawing.h"

namespace regista {
namespace {

constexpr int kBands = 12;  // mown stripes, as wide as a metre on the large field

// Twice the 10 mm of the rules, to be seen at 80 pixels per metre.
constexpr double kLineWidthShare = 0.02 / 12.0;

struct Pen {
  Drawing& drawing;
  double width_m;

  void line(const Vec2& a, const Vec2& b) const {
    add_polyline(drawing, {a, b}, width_m, {layers::kFieldLine_m, palette::kFieldLine});
  }
  void box(const Vec2& low, const Vec2& high) const {
    line(low, {high.x(), low.y()});
    line({high.x(), low.y()}, high);
    line(high, {low.x(), high.y()});
    line({low.x(), high.y()}, low);
  }
};

void draw_grass(Drawing& drawing, const FieldGeometry& field) {
  const Vec2 outer = half_extent(field, 0.0);
  add_rectangle(drawing, -outer, outer, {layers::kStrip_m, palette::kStrip});
  const Vec2 half(field.length_m / 2, field.width_m / 2);
  const double band_m = field.length_m / kBands;
  for (int i = 0; i < kBands; ++i) {
    const double x = -half.x() + i * band_m;
    add_rectangle(drawing, {x, -half.y()}, {x + band_m, half.y()},
                  {layers::kGrass_m, i % 2 == 0 ? palette::kGrass : palette::kGrassBand});
  }
}

/// The half at that side: -1 or +1.
void draw_half(const Pen& pen, const FieldGeometry& field, double side) {
  const double goal_line = side * field.length_m / 2;
  const double front = goal_line - side * field.defence_depth_m;
  pen.box({std::min(goal_line, front), -field.defence_width_m / 2},
          {std::max(goal_line, front), field.defence_width_m / 2});
  const bool yellow = (side > 0) == field.yellow_on_positive_x;
  const double back = goal_line + side * field.goal_depth_m;
  const double post = field.goal_width_m / 2;
  const Paint paint{layers::kFieldLine_m, color_of(yellow ? Team::yellow : Team::blue)};
  add_polyline(pen.drawing, {{goal_line, post}, {back, post}, {back, -post}, {goal_line, -post}},
               std::max(field.goal_wall_m, 2 * pen.width_m), paint);
}

}  // namespace

Drawing draw_field(const FieldGeometry& field) {
  Drawing drawing;
  draw_grass(drawing, field);
  const Pen pen{drawing, kLineWidthShare * field.length_m};
  const Vec2 half(field.length_m / 2, field.width_m / 2);
  pen.box(-half, half);
  pen.line({0.0, -half.y()}, {0.0, half.y()});
  pen.line({-half.x(), 0.0}, {half.x(), 0.0});
  add_ring(drawing, Vec2::Zero(), field.centre_circle_radius_m, pen.width_m,
           {layers::kFieldLine_m, palette::kFieldLine});
  add_disc(drawing, Vec2::Zero(), 2 * pen.width_m, {layers::kFieldLine_m, palette::kFieldLine});
  draw_half(pen, field, -1.0);
  draw_half(pen, field, +1.0);
  return drawing;
}

}  // namespace regista
