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

/// The lower 16 bits, each moved to twice its place.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | (bits << 8)) & 0x00FF00FFU;
  bits = (bits | (bits << 4)) & 0x0F0F0F0FU;
  bits = (bits | (bits << 2)) & 0x33333333U;
  return (bits | (bits << 1)) & 0x55555555U;
}

}  // namespace

void ObstacleBoxes::Columns::clear() {
  for (std::vector<float>* column : {&x, &y, &half_x, &half_y, &radius}) column->clear();
}

void ObstacleBoxes::Columns::add(const Vec2& low, const Vec2& high, double radius_m) {
  const Vec2 centre = 0.5 * (low + high);
  const Vec2 half = 0.5 * (high - low);
  x.push_back(static_cast<float>(centre.x()));
  y.push_back(static_cast<float>(centre.y()));
  half_x.push_back(static_cast<float>(half.x()));
  half_y.push_back(static_cast<float>(half.y()));
  radius.push_back(static_cast<float>(radius_m));
}

void ObstacleBoxes::Columns::pad() {
  const std::size_t size = (x.size() + Lanes::size() - 1) / Lanes::size() * Lanes::size();
  for (std::vector<float>* column : {&x, &y, &half_x, &half_y}) column->resize(size, 0.0F);
  radius.resize(size, kNever);
}

ObstacleBoxes::Sweep::Sweep(const Vec2& from, const Vec2& to, double radius_m) {
  const Vec2 along = to - from;
  const Vec2 middle = from + 0.5 * along;
  const double length = along.norm();
  const Vec2 unit = length > 0.0 ? Vec2(along / length) : Vec2::Zero();
  x = static_cast<float>(middle.x());
  y = static_cast<float>(middle.y());
  half_x = static_cast<float>(0.5 * std::abs(along.x()));
  half_y = static_cast<float>(0.5 * std::abs(along.y()));
  along_x = static_cast<float>(unit.x());
  along_y = static_cast<float>(unit.y());
  across_x = static_cast<float>(std::abs(unit.y()));
  across_y = static_cast<float>(std::abs(unit.x()));
  radius = static_cast<float>(radius_m);
}

void ObstacleBoxes::assign(std::span<const Obstacle> obstacles) {
  boxes_.clear();
  groups_.clear();
  index_.clear();
  extent_m_ = 0.0;
  for (const Obstacle& obstacle : obstacles) {
    const Vec2 reach = obstacle.a.cwiseAbs().cwiseMax(obstacle.b.cwiseAbs());
    extent_m_ = std::max(extent_m_, reach.maxCoeff() + obstacle.radius_m);
  }
  if (obstacles.size() > kSmallField) {
    assign_groups(obstacles);
  } else {
    for (ObstacleIndex i = 0; i < obstacles.size(); ++i) index_.push_back(i);
  }
  for (const ObstacleIndex i : index_) boxes_.add(low_of(obstacles[i]), high_of(obstacles[i]), obstacles[i].radius_m);
  boxes_.pad();
}

/// Sorts by the place of the centres on a Z-order curve (Morton), so that neighbours in the list are neighbours in the
/// field.
void ObstacleBoxes::assign_groups(std::span<const Obstacle> obstacles) {
  constexpr double kCells = 65535.0;
  const double scale = extent_m_ > 0.0 ? 0.5 * kCells / extent_m_ : 0.0;
  order_.clear();
  for (ObstacleIndex i = 0; i < obstacles.size(); ++i) {
    const Vec2 place = (0.5 * (obstacles[i].a + obstacles[i].b) + Vec2::Constant(extent_m_)) * scale;
    order_.emplace_back(
        spread(static_cast<std::uint64_t>(place.x())) | (spread(static_cast<std::uint64_t>(place.y())) << 1), i);
  }
  std::sort(order_.begin(), order_.end());
  for (std::size_t begin = 0; begin < order_.size(); begin += kGroupSize) {
    Vec2 low = Vec2::Constant(extent_m_);
    Vec2 high = -low;
    for (std::size_t i = begin; i < std::min(begin + kGroupSize, order_.size()); ++i) {
      const Obstacle& obstacle = obstacles[order_[i].second];
      low = low.cwiseMin(low_of(obstacle) - Vec2::Constant(obstacle.radius_m));
      high = high.cwiseMax(high_of(obstacle) + Vec2::Constant(obstacle.radius_m));
      index_.push_back(order_[i].second);
    }
    groups_.add(low, high, 0.0);
  }
  groups_.pad();
}

}  // namespace regista
