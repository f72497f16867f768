#include "modules/viewer/drawing.h"

#include <cmath>
#include <numbers>

namespace regista {
namespace {

// A circle of the centre circle's size shows no corners at two thousand pixels across.
constexpr int kCircleCorners = 48;
constexpr int kSmallCircleCorners = 12;  // for round joints, a few pixels wide
constexpr double kSmallCircle_m = 0.03;

std::array<float, 3> corner(const Vec2& p, double z_m) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(z_m)};
}

Vec2 on_circle(const Vec2& centre, double radius_m, int index, int corners) {
  const double angle = 2.0 * std::numbers::pi * index / corners;
  return centre + radius_m * Vec2(std::cos(angle), std::sin(angle));
}

int corners_of(double radius_m) { return radius_m <= kSmallCircle_m ? kSmallCircleCorners : kCircleCorners; }

}  // namespace

Color mixed(Color a, Color b, double share) {
  const auto mix = [share](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(std::lround((1.0 - share) * x + share * y));
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

void add_triangle(Drawing& drawing, const std::array<Vec2, 3>& corners, Paint paint) {
  drawing.push_back(
      {{corner(corners[0], paint.z_m), corner(corners[1], paint.z_m), corner(corners[2], paint.z_m)}, paint.color});
}

void add_polygon(Drawing& drawing, const std::vector<Vec2>& corners, Paint paint) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    add_triangle(drawing, {corners[0], corners[i - 1], corners[i]}, paint);
  }
}

void add_wall(Drawing& drawing, const std::vector<Vec2>& corners, double z_low_m, Paint paint) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& a = corners[i];
    const Vec2& b = corners[(i + 1) % corners.size()];
    drawing.push_back({{corner(a, z_low_m), corner(b, z_low_m), corner(b, paint.z_m)}, paint.color});
    drawing.push_back({{corner(a, z_low_m), corner(b, paint.z_m), corner(a, paint.z_m)}, paint.color});
  }
}

void add_rectangle(Drawing& drawing, const Vec2& low, const Vec2& high, Paint paint) {
  add_polygon(drawing, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, paint);
}

void add_segment(Drawing& drawing, const Vec2& a, const Vec2& b, double width_m, Paint paint) {
  const Vec2 along = b - a;
  const double length = along.norm();
  if (length == 0.0) return;
  const Vec2 side = Vec2(-along.y(), along.x()) * (width_m / 2 / length);
  add_polygon(drawing, {a - side, b - side, b + side, a + side}, paint);
}

void add_polyline(Drawing& drawing, const std::vector<Vec2>& points, double width_m, Paint paint) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    add_disc(drawing, points[i], width_m / 2, paint);
    if (i > 0) add_segment(drawing, points[i - 1], points[i], width_m, paint);
  }
}

void add_disc(Drawing& drawing, const Vec2& centre, double radius_m, Paint paint) {
  const int corners = corners_of(radius_m);
  for (int i = 0; i < corners; ++i) {
    add_triangle(drawing,
                 {centre, on_circle(centre, radius_m, i, corners), on_circle(centre, radius_m, i + 1, corners)}, paint);
  }
}

void add_ring(Drawing& drawing, const Vec2& centre, double radius_m, double width_m, Paint paint) {
  const int corners = corners_of(radius_m);
  const double inner = radius_m - width_m / 2;
  const double outer = radius_m + width_m / 2;
  for (int i = 0; i < corners; ++i) {
    add_polygon(drawing,
                {on_circle(centre, inner, i, corners), on_circle(centre, outer, i, corners),
                 on_circle(centre, outer, i + 1, corners), on_circle(centre, inner, i + 1, corners)},
                paint);
  }
}

}  // namespace regista
