#include "modules/ssl/ssl_geometry_convert.h"

#include <optional>
#include <string>

#include "modules/convert/common.h"
#include "ssl_vision_geometry.pb.h"

namespace regista {
namespace {

constexpr double kMillimetresPerMetre = 1e3;  // divided by, so that 1800 mm are 1.8 m to the last bit
constexpr double kSmallestField_m = 0.1;      // smaller than a robot: a unit error

double metres(double millimetres, double low_m, const char* field) {
  const double value_m = at_least(millimetres / kMillimetresPerMetre, low_m, field);
  require(value_m <= kFarthest_m, field, " is more than 1 km");
  return value_m;
}

/// A defence area's front line, of either side; nullptr where none is drawn. Older sources only name lines, newer ones
/// type them.
const SSL_FieldLineSegment* front_line(const SSL_GeometryFieldSize& size) {
  for (const SSL_FieldLineSegment& line : size.field_lines()) {
    if (line.type() == LeftPenaltyStretch || line.type() == RightPenaltyStretch) return &line;
    if (line.name() == "LeftPenaltyStretch" || line.name() == "RightPenaltyStretch") return &line;
  }
  return nullptr;
}

const SSL_FieldCircularArc* centre_circle(const SSL_GeometryFieldSize& size) {
  for (const SSL_FieldCircularArc& arc : size.field_arcs()) {
    if (arc.type() == CenterCircle || arc.name() == "CenterCircle") return &arc;
  }
  return nullptr;
}

/// The rules' measures for what the source leaves open.
FieldGeometry nearest_division(double length_m) {
  constexpr double kBetween_m = (division_a().length_m + division_b().length_m) / 2;
  return length_m >= kBetween_m ? division_a() : division_b();
}

void set_defence_areas(const SSL_GeometryFieldSize& size, FieldGeometry& field) {
  if (const SSL_FieldLineSegment* line = front_line(size)) {
    const double from_centre_m = metres(std::abs(double{line->p1().x()}), 0.0, "penalty stretch x");
    field.defence_depth_m = field.length_m / 2 - from_centre_m;
    field.defence_width_m = metres(std::abs(double{line->p1().y()} - double{line->p2().y()}), 0.0, "penalty stretch y");
  }
  if (size.has_penalty_area_depth()) {
    field.defence_depth_m = metres(size.penalty_area_depth(), 0.0, "penalty_area_depth");
  }
  if (size.has_penalty_area_width()) {
    field.defence_width_m = metres(size.penalty_area_width(), 0.0, "penalty_area_width");
  }
  require(field.defence_depth_m >= 0.0 && field.defence_depth_m <= field.length_m / 2 &&
              field.defence_width_m <= field.width_m,
          "a defence area ", field.defence_depth_m, " m deep and ", field.defence_width_m,
          " m wide does not fit its half of the field");
}

void set_centre_circle(const SSL_GeometryFieldSize& size, FieldGeometry& field) {
  if (const SSL_FieldCircularArc* arc = centre_circle(size)) {
    field.centre_circle_radius_m = metres(double{arc->radius()}, 0.0, "centre circle radius");
  }
  if (size.has_center_circle_radius()) {
    field.centre_circle_radius_m = metres(size.center_circle_radius(), 0.0, "center_circle_radius");
  }
}

}  // namespace

FieldGeometry to_field_geometry(const SSL_GeometryData& geometry, bool yellow_on_positive_x) {
  const SSL_GeometryFieldSize& size = geometry.field();
  const double length_m = metres(size.field_length(), kSmallestField_m, "field_length");
  FieldGeometry field = nearest_division(length_m);
  field.length_m = length_m;
  field.width_m = metres(size.field_width(), kSmallestField_m, "field_width");
  field.goal_width_m = metres(size.goal_width(), 0.0, "goal_width");
  field.goal_depth_m = metres(size.goal_depth(), 0.0, "goal_depth");
  field.margin_touch_line_m = metres(size.boundary_width(), 0.0, "boundary_width");
  field.margin_goal_line_m = size.has_boundary_width_goal_line()
                                 ? metres(size.boundary_width_goal_line(), 0.0, "boundary_width_goal_line")
                                 : field.margin_touch_line_m;
  set_defence_areas(size, field);
  set_centre_circle(size, field);
  field.yellow_on_positive_x = yellow_on_positive_x;
  return field;
}

}  // namespace regista
