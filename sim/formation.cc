#include "sim/formation.h"

#include <numbers>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

constexpr double kSpacingMax_m = 2.0;  // looks like a team; more would leave it in one column
constexpr double kSpacingStep = 0.95;  // how the spacing shrinks until all fit
constexpr double kGapMin_m = 0.05;     // between two discs: room to start moving
constexpr double kAreaMargin_m = 0.1;  // between a disc and its own defence area

// Grid points of one half, the own goal at -x, column by column from the centre line.
std::vector<Vec2> grid(const FieldGeometry& field, const Vec2& keeper, double spacing_m, double radius_m) {
  const double x_last = -(field.length_m / 2.0 - radius_m);
  const double half_width = field.width_m / 2.0 - radius_m;
  const double area_x = -(field.length_m / 2.0 - field.defence_depth_m) + radius_m + kAreaMargin_m;
  const double area_y = field.defence_width_m / 2.0 + radius_m + kAreaMargin_m;
  std::vector<Vec2> points;
  if (half_width < 0.0) return points;
  const int rows = static_cast<int>(2.0 * half_width / spacing_m) + 1;
  for (double x = -spacing_m / 2.0; x >= x_last; x -= spacing_m) {
    for (int row = 0; row < rows; ++row) {
      const Vec2 point(x, (row - (rows - 1) / 2.0) * spacing_m);
      const bool in_area = point.x() < area_x && std::abs(point.y()) < area_y;
      if (!in_area && (point - keeper).norm() >= 2.0 * radius_m + kGapMin_m) points.push_back(point);
    }
  }
  return points;
}

}  // namespace

std::vector<RobotPlacement> formation(const FieldGeometry& field, int robots_per_team, double radius_m) {
  if (robots_per_team < 1 || robots_per_team > 65536 || !(radius_m > 0.0)) {
    throw std::invalid_argument("formation of " + std::to_string(robots_per_team) + " robots of radius " +
                                std::to_string(radius_m) + " m");
  }
  const Vec2 keeper(-(field.length_m - field.defence_depth_m) / 2.0, 0.0);
  const auto needed = static_cast<std::size_t>(robots_per_team) - 1;
  const double spacing_min = 2.0 * radius_m + kGapMin_m;
  double spacing = kSpacingMax_m;
  std::vector<Vec2> points = grid(field, keeper, spacing, radius_m);
  while (points.size() < needed && spacing > spacing_min) {
    spacing = std::max(spacing * kSpacingStep, spacing_min);
    points = grid(field, keeper, spacing, radius_m);
  }
  if (points.size() < needed) {
    throw std::invalid_argument(std::to_string(robots_per_team) + " robots per team do not fit on half of a field of " +
                                std::to_string(field.length_m) + " x " + std::to_string(field.width_m) +
                                " m, at most " + std::to_string(points.size() + 1) + " do");
  }
  points.insert(points.begin(), keeper);
  std::vector<RobotPlacement> placements;
  for (const Team team : {Team::yellow, Team::blue}) {
    const bool negative = defends_negative_x(team, field);
    for (std::size_t i = 0; i <= needed; ++i) {
      const auto number = static_cast<std::uint16_t>(i);
      const Vec2& point = points[i];
      const Vec2 position(negative ? point.x() : -point.x(), point.y());
      placements.push_back({{team, number}, {position, negative ? 0.0 : std::numbers::pi}});
    }
  }
  return placements;
}

}  // namespace regista
