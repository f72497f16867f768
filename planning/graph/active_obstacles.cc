#include "planning/graph/active_obstacles.h"

namespace regista::graph {
namespace {

/// So many are tested at once as fast as one of them.
constexpr std::size_t kFew = 8;

}  // namespace

void ActiveObstacles::clear(std::size_t obstacles) {
  slots_.clear();
  list_.clear();
  boxes_.clear();
  is_active_.assign(obstacles, 0);
  recent_ = kBounds;
}

void ActiveObstacles::add(const ObstacleField& field, ObstacleIndex obstacle, const Vec2& goal) {
  const Obstacle& shape = field.obstacles()[obstacle];
  const Vec2 middle = 0.5 * (shape.a + shape.b);
  const double extent_m = (shape.b - middle).norm() + shape.radius_m;
  boxes_.append(shape, static_cast<std::uint32_t>(slots_.size()));
  slots_.push_back({body_of(shape), obstacle, middle, extent_m, (middle - goal).norm() - extent_m});
  list_.push_back(obstacle);
  is_active_[obstacle] = 1;
}

bool ActiveObstacles::are_clear_of(const ObstacleField& field, ObstacleBoxes::Motion motion, std::uint32_t from,
                                   std::uint32_t to) {
  const auto blocks = [&](std::uint32_t slot) {
    return slot != from && slot != to && !is_free(motion.from, motion.to, field.obstacles()[list_[slot]]);
  };
  // What blocked a leg blocks its neighbours as well. Among few it is not worth the question.
  if (slots_.size() > kFew && recent_ != kBounds && blocks(recent_)) return false;
  motion.left_out = left_out_bit(from) | left_out_bit(to);
  bool is_blocked = false;
  boxes_.visit_near(motion, [&](std::uint32_t slot) {
    is_blocked = blocks(slot);
    if (is_blocked) recent_ = slot;
    return is_blocked;
  });
  return !is_blocked;
}

}  // namespace regista::graph
