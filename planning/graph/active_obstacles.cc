#include "planning/graph/active_obstacles.h"

namespace regista::graph {
namespace {

/// So many are tested at once as fast as one of them.
constexpr std::size_t kFew = 8;

}  // namespace

void ActiveObstacles::clear(std::size_t obstacles) {
  slots_.clear();
  discs_.clear();
  list_.clear();
  boxes_.clear();
  is_active_.assign(obstacles, 0);
}

void ActiveObstacles::add(const ObstacleField& field, ObstacleIndex obstacle, const Vec2& goal) {
  const Obstacle& shape = field.obstacles()[obstacle];
  const Vec2 middle = 0.5 * (shape.a + shape.b);
  const double extent_m = (shape.b - middle).norm() + shape.radius_m;
  const std::size_t lane = slots_.size() % kLanes;
  if (lane == 0) discs_.emplace_back();
  discs_.back().x[lane] = middle.x();
  discs_.back().y[lane] = middle.y();
  discs_.back().extent[lane] = extent_m;
  discs_.back().to_goal[lane] = (middle - goal).norm() - 2.0 * extent_m;
  boxes_.append(shape, static_cast<std::uint32_t>(slots_.size()));
  slots_.push_back({body_of(shape), obstacle});
  list_.push_back(obstacle);
  is_active_[obstacle] = 1;
}

/// To the disc, at best along it, and on to the goal. What lies beyond the tangent where a narrow window begins has no
/// leg.
ActiveObstacles::Lanes ActiveObstacles::least_m(const Departure& departure, const Discs& discs) {
  const auto load = [](const std::array<double, kLanes>& column) {
    return Lanes(column.data(), std::experimental::element_aligned);
  };
  const Lanes x = load(discs.x) - departure.point.x();
  const Lanes y = load(discs.y) - departure.point.y();
  Lanes least = std::experimental::sqrt(x * x + y * y) + (load(discs.to_goal) + departure.cost_m);
  if (departure.window.is_narrow) {
    const Vec2& normal = departure.window.begin;
    where(normal.x() * x + normal.y() * y > load(discs.extent), least) = std::numeric_limits<double>::infinity();
  }
  return least;
}

std::span<const double> ActiveObstacles::least_ways_m(const Departure& departure) {
  least_ways_m_.resize(discs_.size() * kLanes);
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    least_m(departure, discs_[i]).copy_to(least_ways_m_.data() + i * kLanes, std::experimental::element_aligned);
  }
  return {least_ways_m_.data(), slots_.size()};
}

double ActiveObstacles::least_way_m(const Departure& departure, std::uint32_t slot) const {
  return least_m(departure, discs_[slot / kLanes])[slot % kLanes];
}

bool ActiveObstacles::are_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion, std::uint32_t from,
                                   std::uint32_t to, Occluders& occluders) const {
  // Among few it is not worth the question.
  const bool are_many = slots_.size() > kFew;
  if (are_many && occluders.surely_block(motion.from, motion.along, (motion.to - motion.from).dot(motion.along))) {
    return false;
  }
  bool is_blocked = false;
  boxes_.visit_near({motion.from, motion.to, motion.along, 0.0, left_out_bit(from) | left_out_bit(to)},
                    [&](std::uint32_t slot) {
                      const Obstacle& obstacle = field.obstacles()[list_[slot]];
                      is_blocked = slot != from && slot != to && !is_free(motion.from, motion.to, obstacle);
                      if (is_blocked && are_many) occluders.add(obstacle);
                      return is_blocked;
                    });
  return !is_blocked;
}

}  // namespace regista::graph
