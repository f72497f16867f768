#include "planning/obstacle_boxes.h"

#include <algorithm>

namespace regista {
namespace {

/// From here on groups are faster than asking all boxes.
constexpr std::size_t kSmallField = 64;

/// A padding box: its radius is below minus anything, so nothing is near enough.
constexpr float kNever = -1e30F;

/// The core's box.
Vec2 middle_of(const Obstacle& obstacle) { return 0.5 * (obstacle.a + obstacle.b); }
Vec2 half_of(const Obstacle& obstacle) { return 0.5 * (obstacle.b - obstacle.a).cwiseAbs(); }

/// No coordinate of it is larger.
Vec2 reach_of(const Obstacle& obstacle) {
  return obstacle.a.cwiseAbs().cwiseMax(obstacle.b.cwiseAbs()) + Vec2::Constant(obstacle.radius_m);
}

}  // namespace

void ObstacleBoxes::Block::set(std::size_t lane, const Vec2& middle, const Vec2& half, double radius_m) {
  x[lane] = static_cast<float>(middle.x());
  y[lane] = static_cast<float>(middle.y());
  half_x[lane] = static_cast<float>(half.x());
  half_y[lane] = static_cast<float>(half.y());
  radius[lane] = static_cast<float>(radius_m);
}

void ObstacleBoxes::Block::pad(std::size_t lane) {
  x[lane] = y[lane] = half_x[lane] = half_y[lane] = 0.0F;
  radius[lane] = kNever;
}

ObstacleBoxes::Sweep ObstacleBoxes::sweep_of(const Motion& motion) const {
  const double extent_m = std::max({extent_m_, std::abs(motion.from.x()), std::abs(motion.from.y()),
                                    std::abs(motion.to.x()), std::abs(motion.to.y())});
  // Single precision rounds by 6e-8; sums and products of four numbers stay below ten times that.
  const double radius_m = motion.radius_m + 1e-6 * extent_m;
  const Vec2 half = 0.5 * (motion.to - motion.from);
  const auto unit_x = static_cast<float>(motion.along.x());
  const auto unit_y = static_cast<float>(motion.along.y());
  Sweep sweep;
  sweep.x = static_cast<float>(motion.from.x() + half.x());
  sweep.y = static_cast<float>(motion.from.y() + half.y());
  sweep.half_x = static_cast<float>(std::abs(half.x()) + radius_m);
  sweep.half_y = static_cast<float>(std::abs(half.y()) + radius_m);
  sweep.along_x = unit_x;
  sweep.along_y = unit_y;
  sweep.across_x = std::abs(unit_y);
  sweep.across_y = std::abs(unit_x);
  sweep.radius = static_cast<float>(radius_m);
  return sweep;
}

/// Not separated along x, along y, or across the segment (for a point as core, exactly by its distance to the line).
std::uint64_t ObstacleBoxes::hits(const Block* begin, const Block* end, const Sweep& sweep) {
  using std::experimental::abs;
  const auto load = [](const std::array<float, kLanes>& column) {
    return Lanes(column.data(), std::experimental::vector_aligned);
  };
  std::uint64_t hits = 0;
  std::size_t lane = 0;
  for (const Block* block = begin; block != end; ++block, lane += kLanes) {
    const Lanes x = load(block->x) - sweep.x;
    const Lanes y = load(block->y) - sweep.y;
    const Lanes half_x = load(block->half_x);
    const Lanes half_y = load(block->half_y);
    const Lanes radius = load(block->radius);
    const auto hit = abs(x) <= half_x + (radius + sweep.half_x) && abs(y) <= half_y + (radius + sweep.half_y) &&
                     abs(sweep.along_x * y - sweep.along_y * x) <=
                         sweep.across_x * half_x + (sweep.across_y * half_y + (radius + sweep.radius));
    hits |= static_cast<std::uint64_t>(hit.__to_bitset().to_ulong()) << lane;
  }
  return hits;
}

void ObstacleBoxes::clear() {
  extent_m_ = 0.0;
  groups_.clear();
  index_.clear();
  blocks_.clear();
}

void ObstacleBoxes::append(const Obstacle& obstacle, ObstacleIndex index) {
  extent_m_ = std::max(extent_m_, reach_of(obstacle).maxCoeff());
  const std::size_t lane = index_.size() % kLanes;
  if (lane == 0) {
    blocks_.emplace_back();
    for (std::size_t i = 0; i < kLanes; ++i) blocks_.back().pad(i);
  }
  blocks_.back().set(lane, middle_of(obstacle), half_of(obstacle), obstacle.radius_m);
  index_.push_back(index);
}

void ObstacleBoxes::assign(std::span<const Obstacle> obstacles) {
  Vec2 extent = Vec2::Zero();
  for (const Obstacle& obstacle : obstacles) extent = extent.cwiseMax(reach_of(obstacle));
  extent_m_ = extent.maxCoeff();
  groups_.clear();
  index_.resize(obstacles.size());
  blocks_.resize((obstacles.size() + kLanes - 1) / kLanes);
  if (obstacles.size() > kSmallField) {
    sort_into_groups(obstacles);
  } else {
    for (ObstacleIndex i = 0; i < obstacles.size(); ++i) index_[i] = i;
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Obstacle& obstacle = obstacles[index_[i]];
    blocks_[i / kLanes].set(i % kLanes, middle_of(obstacle), half_of(obstacle), obstacle.radius_m);
  }
  for (std::size_t i = obstacles.size(); i < blocks_.size() * kLanes; ++i) blocks_[i / kLanes].pad(i % kLanes);
}

/// Neighbours in the list are to be neighbours in the field.
void ObstacleBoxes::sort_into_groups(std::span<const Obstacle> obstacles) {
  order_.clear(extent_m_);
  for (const Obstacle& obstacle : obstacles) order_.add(middle_of(obstacle));
  const std::span<const ZOrder::Entry> order = order_.sort();
  const std::size_t groups = (order.size() + kGroupSize - 1) / kGroupSize;
  groups_.resize((groups + kLanes - 1) / kLanes);
  for (std::size_t group = 0; group < groups; ++group) {
    Vec2 low = Vec2::Constant(extent_m_);
    Vec2 high = -low;
    for (std::size_t i = group * kGroupSize; i < std::min((group + 1) * kGroupSize, order.size()); ++i) {
      index_[i] = order[i].index;
      const Obstacle& obstacle = obstacles[index_[i]];
      const Vec2 reach = half_of(obstacle) + Vec2::Constant(obstacle.radius_m);
      low = low.cwiseMin(middle_of(obstacle) - reach);
      high = high.cwiseMax(middle_of(obstacle) + reach);
    }
    groups_[group / kLanes].set(group % kLanes, 0.5 * (low + high), 0.5 * (high - low), 0.0);
  }
  for (std::size_t i = groups; i < groups_.size() * kLanes; ++i) groups_[i / kLanes].pad(i % kLanes);
}

}  // namespace regista
