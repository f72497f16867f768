// The field's measures, with the two divisions of the SSL as presets (rules: "Field setup", 2.1).
#pragma once

#include "world_model/types/geometry.h"

namespace regista {

/// All lengths in metres. Yellow defends the goal at -x unless yellow_on_positive_x.
struct FieldGeometry {
  double length_m = 12.0;            ///< goal line to goal line, > 0
  double width_m = 9.0;              ///< touch line to touch line, > 0
  double margin_goal_line_m = 0.6;   ///< boundary strip beyond the goal lines, >= 0
  double margin_touch_line_m = 0.3;  ///< boundary strip beyond the touch lines, >= 0
  double defence_depth_m = 1.8;      ///< of a defence area, along x
  double defence_width_m = 3.6;      ///< of a defence area, along y
  double goal_width_m = 1.8;
  double goal_depth_m = 0.18;
  double goal_wall_m = 0.02;  ///< thickness of the goal's walls
  double centre_circle_radius_m = 0.5;
  bool yellow_on_positive_x = false;
  bool operator==(const FieldGeometry&) const = default;
};

constexpr FieldGeometry division_a() { return {}; }

constexpr FieldGeometry division_b() {
  FieldGeometry field;
  field.length_m = 9.0;
  field.width_m = 6.0;
  field.margin_goal_line_m = 0.3;
  field.margin_touch_line_m = 0.3;
  field.defence_depth_m = 1.0;
  field.defence_width_m = 2.0;
  field.goal_width_m = 1.0;
  return field;
}

/// Half the extent in which the centre of a robot of that radius may be: up to the wall, along x and y.
inline Vec2 half_extent(const FieldGeometry& field, double radius_m) {
  return {field.length_m / 2 + field.margin_goal_line_m - radius_m,
          field.width_m / 2 + field.margin_touch_line_m - radius_m};
}

}  // namespace regista
