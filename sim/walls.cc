#include "sim/walls.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

void bounce(const Vec2& normal, double restitution, Vec2& velocity_mps) {
  const double into = -velocity_mps.dot(normal);
  if (into > 0.0) velocity_mps += (1.0 + restitution) * into * normal;
}

void keep_off_box(const Box& box, double radius_m, double restitution, Vec2& position_m, Vec2& velocity_mps) {
  const Vec2 nearest = position_m.cwiseMax(box.low).cwiseMin(box.high);
  const Vec2 off = position_m - nearest;
  const double distance = off.norm();
  if (distance >= radius_m) return;
  if (distance > 0.0) {
    const Vec2 normal = off / distance;
    position_m = nearest + radius_m * normal;
    bounce(normal, restitution, velocity_mps);
    return;
  }
  // The centre is inside the wall: out by the nearest side.
  const Vec2 to_low = position_m - box.low;
  const Vec2 to_high = box.high - position_m;
  const int axis = std::min(to_low.x(), to_high.x()) <= std::min(to_low.y(), to_high.y()) ? 0 : 1;
  const bool low_side = to_low[axis] < to_high[axis];
  Vec2 normal = Vec2::Zero();
  normal[axis] = low_side ? -1.0 : 1.0;
  position_m[axis] = low_side ? box.low[axis] - radius_m : box.high[axis] + radius_m;
  bounce(normal, restitution, velocity_mps);
}

}  // namespace

Walls walls_of(const FieldGeometry& field) {
  const double line = field.length_m / 2.0;
  const double back = line + field.goal_depth_m;
  const double outer = back + field.goal_wall_m;
  const double inside = field.goal_width_m / 2.0;
  const double outside = inside + field.goal_wall_m;
  Walls walls{half_extent(field, 0.0), line, {}};
  for (const double side : {-1.0, 1.0}) {
    const auto add = [&](double x1, double y1, double x2, double y2) {
      const Vec2 a(side * x1, y1);
      const Vec2 b(side * x2, y2);
      walls.goals.push_back({a.cwiseMin(b), a.cwiseMax(b)});
    };
    add(back, -outside, outer, outside);
    add(line, inside, outer, outside);
    add(line, -outside, outer, -inside);
  }
  return walls;
}

void keep_off(const Walls& walls, double radius_m, double restitution, Vec2& position_m, Vec2& velocity_mps) {
  if (std::abs(position_m.x()) + radius_m > walls.goal_line_m) {
    for (const Box& box : walls.goals) keep_off_box(box, radius_m, restitution, position_m, velocity_mps);
  }
  for (int axis = 0; axis < 2; ++axis) {
    const double limit = walls.half_extent_m[axis] - radius_m;
    if (std::abs(position_m[axis]) <= limit) continue;
    Vec2 normal = Vec2::Zero();
    normal[axis] = position_m[axis] > 0.0 ? -1.0 : 1.0;
    position_m[axis] = std::copysign(limit, position_m[axis]);
    bounce(normal, restitution, velocity_mps);
  }
}

}  // namespace regista
