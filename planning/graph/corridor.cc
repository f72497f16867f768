#include "planning/graph/corridor.h"

namespace regista::graph {

void Corridor::lay_out(const ObstacleField& field, const Vec2& from, const Vec2& to, double radius_m) {
  from_ = from;
  to_ = to;
  radius_m_ = radius_m;
  boxes_.clear();
  field.visit_maybe_near(from, to, radius_m, [&](ObstacleIndex i) { boxes_.append(field.obstacles()[i], i); });
}

}  // namespace regista::graph
