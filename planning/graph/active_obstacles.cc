#include "planning/graph/active_obstacles.h"

namespace regista::graph {
void ActiveObstacles::clear(std::size_t obstacles) {
  slots_.clear();
  discs_.clear();
  blockers_.clear(obstacles);
}

void ActiveObstacles::add(const ObstacleField& field, ObstacleIndex obstacle, const Body& body, const Vec2& goal) {
  const Obstacle& shape = field.obstacles()[obstacle];
  const Vec2 middle = 0.5 * (shape.a + shape.b);
  const double extent_m = (shape.b - middle).norm() + shape.radius_m;
  const std::size_t lane = slots_.size() % kLanes;
  if (lane == 0) discs_.emplace_back();
  discs_.back().x[lane] = middle.x();
  discs_.back().y[lane] = middle.y();
  discs_.back().extent[lane] = extent_m;
  discs_.back().to_goal[lane] = (middle - goal).norm() - 2.0 * extent_m;
  blockers_.add(field, obstacle);
  slots_.push_back({body, obstacle});
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

}  // namespace regista::graph
