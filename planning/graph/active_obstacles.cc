#include "planning/graph/active_obstacles.h"

namespace regista::graph {
namespace {

/// So many are looked at one by one.
constexpr std::size_t kFew = 4;

/// Double precision rounds by 1e-16; sums and products of four numbers stay far below.
constexpr double kRounding = 1e-12;

/// The bit of a slot; none for what is no slot of few.
std::uint64_t bit_of(std::uint32_t slot) { return slot < kFew ? std::uint64_t{1} << slot : 0; }

}  // namespace

void ActiveObstacles::clear(std::size_t obstacles) {
  slots_.clear();
  discs_.clear();
  around_.clear();
  list_.clear();
  boxes_.clear();
  is_active_.assign(obstacles, 0);
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
  around_.push_back(
      {middle, (shape.b - middle).cwiseAbs(), shape.radius_m + kRounding * (middle.cwiseAbs().sum() + extent_m)});
  boxes_.append(shape, static_cast<std::uint32_t>(slots_.size()));
  slots_.push_back({body, obstacle});
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
  if (slots_.size() <= kFew) {
    const std::uint64_t all = (std::uint64_t{1} << slots_.size()) - 1;
    return are_few_clear_of(field, motion, all & ~bit_of(from) & ~bit_of(to));
  }
  if (occluders.surely_block(motion.from, motion.along, (motion.to - motion.from).dot(motion.along))) return false;
  bool is_blocked = false;
  boxes_.visit_near(motion, [&](std::uint32_t slot) {
    const Obstacle& obstacle = field.obstacles()[list_[slot]];
    is_blocked = slot != from && slot != to && !is_free(motion.from, motion.to, obstacle);
    if (is_blocked) occluders.add(obstacle);
    return is_blocked;
  });
  return !is_blocked;
}

/// Those of the bits. Most motions are clear of most boxes, and no branch depends on which.
bool ActiveObstacles::are_few_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion,
                                       std::uint64_t others) const {
  if (others == 0) return true;
  const double rounding_m = kRounding * motion.from.cwiseAbs().sum();
  const Vec2 half = 0.5 * (motion.to - motion.from);
  const Vec2 middle = motion.from + half;
  const Vec2 across = motion.along.cwiseAbs();
  std::uint64_t near = 0;
  for (std::size_t slot = 0; slot < around_.size(); ++slot) {
    const Around& around = around_[slot];
    const Vec2 offset = around.middle - middle;
    const double radius_m = around.radius_m + rounding_m;
    const Vec2 apart = offset.cwiseAbs() - half.cwiseAbs() - around.half;
    const double apart_m =
        std::abs(cross(motion.along, offset)) - across.x() * around.half.y() - across.y() * around.half.x();
    const bool is_near = static_cast<int>(apart_m < radius_m) & static_cast<int>(apart.x() < radius_m) &
                         static_cast<int>(apart.y() < radius_m);
    near |= std::uint64_t{is_near} << slot;
  }
  for (near &= others; near != 0; near &= near - 1) {
    const auto slot = static_cast<std::uint32_t>(std::countr_zero(near));
    if (!is_free(motion.from, motion.to, field.obstacles()[list_[slot]])) return false;
  }
  return true;
}

}  // namespace regista::graph
