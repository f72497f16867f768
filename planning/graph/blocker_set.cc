#include "planning/graph/blocker_set.h"

#include <bit>

namespace regista::graph {
namespace {

/// Double precision rounds by 1e-16; sums and products of four numbers stay far below.
constexpr double kRounding = 1e-12;

/// The bit of a slot; none for what is no slot of few.
std::uint64_t bit_of(std::uint32_t slot) { return slot < 64 ? std::uint64_t{1} << slot : 0; }

}  // namespace

void BlockerSet::clear(std::size_t obstacles) {
  around_.clear();
  list_.clear();
  boxes_.clear();
  is_in_.assign(obstacles, 0);
}

void BlockerSet::add(const ObstacleField& field, ObstacleIndex obstacle) {
  const Obstacle& shape = field.obstacles()[obstacle];
  if (list_.size() < kFew) {
    const Vec2 middle = 0.5 * (shape.a + shape.b);
    const Vec2 half = (shape.b - middle).cwiseAbs();
    around_.push_back(
        {middle, half, shape.radius_m + kRounding * (middle.cwiseAbs().sum() + half.sum() + shape.radius_m)});
  }
  boxes_.append(shape, static_cast<std::uint32_t>(list_.size()));
  list_.push_back(obstacle);
  is_in_[obstacle] = 1;
}

bool BlockerSet::are_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion, std::uint32_t from,
                              std::uint32_t to, Occluders& occluders) const {
  if (is_few()) {
    const std::uint64_t all = (std::uint64_t{1} << list_.size()) - 1;
    return are_few_clear_of(field, motion, all & ~bit_of(from) & ~bit_of(to), occluders);
  }
  if (occluders.surely_block(motion)) return false;
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
bool BlockerSet::are_few_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion, std::uint64_t others,
                                  Occluders& occluders) const {
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
    const Obstacle& obstacle = field.obstacles()[list_[slot]];
    if (is_free(motion.from, motion.to, obstacle)) continue;
    occluders.add(obstacle);
    return false;
  }
  return true;
}

}  // namespace regista::graph
