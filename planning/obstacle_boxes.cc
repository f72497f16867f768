#include "planning/obstacle_boxes.h"

#include <algorithm>

namespace regista {
namespace {

/// From here on groups are faster than asking all boxes.
constexpr std::size_t kSmallField = 64;

/// A padding box: its radius is below minus anything, so nothing is near enough.
constexpr float kNever = -1e30F;

Vec2 low_of(const Obstacle& obstacle) { return obstacle.a.cwiseMin(obstacle.b); }
Vec2 high_of(const Obstacle& obstacle) { return obstacle.a.cwiseMax(obstacle.b); }

/// No coordinate of it is larger.
double reach_of(const Obstacle& obstacle) {
  return obstacle.radius_m + std::max({std::abs(obstacle.a.x()), std::abs(obstacle.a.y()), std::abs(obstacle.b.x()),
                                       std::abs(obstacle.b.y())});
}

/// The lower 16 bits, each moved to twice its place.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | (bits << 8)) & 0x00FF00FFU;
  bits = (bits | (bits << 4)) & 0x0F0F0F0FU;
  bits = (bits | (bits << 2)) & 0x33333333U;
  return (bits | (bits << 1)) & 0x55555555U;
}

}  // namespace

void ObstacleBoxes::Block::set(std::size_t lane, const Vec2& low, const Vec2& high, double radius_m) {
  x[lane] = static_cast<float>(0.5 * (low.x() + high.x()));
  y[lane] = static_cast<float>(0.5 * (low.y() + high.y()));
  half_x[lane] = static_cast<float>(0.5 * (high.x() - low.x()));
  half_y[lane] = static_cast<float>(0.5 * (high.y() - low.y()));
  radius[lane] = static_cast<float>(radius_m);
}

void ObstacleBoxes::Block::pad(std::size_t lane) {
  x[lane] = y[lane] = half_x[lane] = half_y[lane] = 0.0F;
  radius[lane] = kNever;
}

void ObstacleBoxes::clear() {
  extent_m_ = 0.0;
  groups_.clear();
  index_.clear();
  blocks_.clear();
}

void ObstacleBoxes::append(const Obstacle& obstacle, ObstacleIndex index) {
  extent_m_ = std::max(extent_m_, reach_of(obstacle));
  const std::size_t lane = index_.size() % kLanes;
  if (lane == 0) {
    blocks_.emplace_back();
    for (std::size_t i = 0; i < kLanes; ++i) blocks_.back().pad(i);
  }
  blocks_.back().set(lane, low_of(obstacle), high_of(obstacle), obstacle.radius_m);
  index_.push_back(index);
}

void ObstacleBoxes::assign(std::span<const Obstacle> obstacles) {
  extent_m_ = 0.0;
  for (const Obstacle& obstacle : obstacles) {
    extent_m_ = std::max(extent_m_, reach_of(obstacle));
  }
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
    blocks_[i / kLanes].set(i % kLanes, low_of(obstacle), high_of(obstacle), obstacle.radius_m);
  }
  for (std::size_t i = obstacles.size(); i < blocks_.size() * kLanes; ++i) blocks_[i / kLanes].pad(i % kLanes);
}

/// By the place of the centres on a Z-order curve (Morton), so that neighbours in the list are neighbours in the field.
void ObstacleBoxes::sort_into_groups(std::span<const Obstacle> obstacles) {
  constexpr double kCells = 65535.0;
  const double scale = extent_m_ > 0.0 ? 0.5 * kCells / extent_m_ : 0.0;
  order_.clear();
  for (ObstacleIndex i = 0; i < obstacles.size(); ++i) {
    const Vec2 place = (0.5 * (obstacles[i].a + obstacles[i].b) + Vec2::Constant(extent_m_)) * scale;
    order_.emplace_back(
        spread(static_cast<std::uint64_t>(place.x())) | (spread(static_cast<std::uint64_t>(place.y())) << 1), i);
  }
  std::sort(order_.begin(), order_.end());
  const std::size_t groups = (order_.size() + kGroupSize - 1) / kGroupSize;
  groups_.resize((groups + kLanes - 1) / kLanes);
  for (std::size_t group = 0; group < groups; ++group) {
    Vec2 low = Vec2::Constant(extent_m_);
    Vec2 high = -low;
    for (std::size_t i = group * kGroupSize; i < std::min((group + 1) * kGroupSize, order_.size()); ++i) {
      index_[i] = order_[i].second;
      const Obstacle& obstacle = obstacles[index_[i]];
      low = low.cwiseMin(low_of(obstacle) - Vec2::Constant(obstacle.radius_m));
      high = high.cwiseMax(high_of(obstacle) + Vec2::Constant(obstacle.radius_m));
    }
    groups_[group / kLanes].set(group % kLanes, low, high, 0.0);
  }
  for (std::size_t i = groups; i < groups_.size() * kLanes; ++i) groups_[i / kLanes].pad(i % kLanes);
}

}  // namespace regista
