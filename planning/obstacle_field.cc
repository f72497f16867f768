#include "planning/obstacle_field.h"

#include <experimental/simd>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

namespace simd = std::experimental;
using Lanes = simd::native_simd<double>;

/// Fast tests may call a motion suspicious that is free, never the other way round: their reach is larger by this, far
/// above rounding and far below anything that costs time. Square metres, and metres.
constexpr double kSlack = 1e-9;

/// Padding: a place that no finite motion comes near, with arithmetic that stays finite.
constexpr double kFarAway_m = 1e100;

Lanes load(const std::vector<double>& values, std::size_t i) { return Lanes(&values[i], simd::element_aligned); }

void pad(std::vector<double>& values, double filling) {
  while (values.size() % Lanes::size() != 0) values.push_back(filling);
}

std::string text(const Vec2& v) { return "(" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ")"; }

void check(const Bounds& bounds, std::span<const Obstacle> obstacles) {
  if (!is_finite(bounds.half_extent_m) || bounds.half_extent_m.minCoeff() < 0.0) {
    throw std::invalid_argument("bounds must be finite and not negative, not " + text(bounds.half_extent_m) + " m");
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Obstacle& obstacle = obstacles[i];
    if (is_valid(obstacle)) continue;
    throw std::invalid_argument("obstacle " + std::to_string(i) + " must be finite with a radius >= 0, not " +
                                text(obstacle.a) + " " + text(obstacle.b) + " radius " +
                                std::to_string(obstacle.radius_m) + " m");
  }
}

}  // namespace

ObstacleField::ObstacleField(const Bounds& bounds, std::vector<Obstacle> obstacles)
    : bounds_(bounds), obstacles_(std::move(obstacles)) {
  check(bounds_, obstacles_);
  for (ObstacleIndex i = 0; i < obstacles_.size(); ++i) {
    const Obstacle& obstacle = obstacles_[i];
    if (obstacle.core == Core::point) {
      disc_x_.push_back(obstacle.a.x());
      disc_y_.push_back(obstacle.a.y());
      disc_reach2_.push_back(obstacle.radius_m * obstacle.radius_m + kSlack);
      disc_index_.push_back(i);
    } else {
      const Vec2 half = 0.5 * (obstacle.b - obstacle.a).cwiseAbs();
      const Vec2 centre = 0.5 * (obstacle.a + obstacle.b);
      box_x_.push_back(centre.x());
      box_y_.push_back(centre.y());
      box_half_x_.push_back(half.x() + obstacle.radius_m + kSlack);
      box_half_y_.push_back(half.y() + obstacle.radius_m + kSlack);
      box_index_.push_back(i);
    }
  }
  pad(disc_x_, kFarAway_m);
  pad(disc_y_, kFarAway_m);
  pad(disc_reach2_, 0.0);
  pad(box_x_, kFarAway_m);
  pad(box_y_, kFarAway_m);
  pad(box_half_x_, 0.0);
  pad(box_half_y_, 0.0);
}

/// Calls visit(index) for each obstacle the segment may come into, until visit returns true.
template <class Visit>
void ObstacleField::for_candidates(const Vec2& from, const Vec2& to, Visit&& visit) const {
  const auto visit_lanes = [&visit](const auto& hit, const std::vector<ObstacleIndex>& index, std::size_t block) {
    for (std::size_t lane = 0; lane < Lanes::size(); ++lane) {
      if (hit[lane] && visit(index[block + lane])) return true;
    }
    return false;
  };
  const Vec2 along = to - from;
  const double length2 = along.squaredNorm();
  const Lanes from_x = from.x(), from_y = from.y(), along_x = along.x(), along_y = along.y();
  const Lanes per_length2 = length2 > 0.0 ? 1.0 / length2 : 0.0;
  const Lanes zero = 0.0, one = 1.0;
  for (std::size_t i = 0; i < disc_x_.size(); i += Lanes::size()) {
    // Distance from the centre to the nearest place of the segment.
    const Lanes x = load(disc_x_, i) - from_x;
    const Lanes y = load(disc_y_, i) - from_y;
    const Lanes t = simd::min(simd::max((x * along_x + y * along_y) * per_length2, zero), one);
    const Lanes dx = x - t * along_x;
    const Lanes dy = y - t * along_y;
    const auto hit = dx * dx + dy * dy < load(disc_reach2_, i);
    if (simd::any_of(hit) && visit_lanes(hit, disc_index_, i)) return;
  }
  // Boxes: separated along x, along y, or across the segment.
  const Vec2 middle = from + 0.5 * along;
  const Lanes middle_x = middle.x(), middle_y = middle.y();
  const Lanes half_x = 0.5 * std::abs(along.x()), half_y = 0.5 * std::abs(along.y());
  const Lanes across_x = std::abs(along.y()), across_y = std::abs(along.x());
  for (std::size_t i = 0; i < box_x_.size(); i += Lanes::size()) {
    const Lanes x = load(box_x_, i) - middle_x;
    const Lanes y = load(box_y_, i) - middle_y;
    const Lanes box_half_x = load(box_half_x_, i);
    const Lanes box_half_y = load(box_half_y_, i);
    const auto hit = simd::abs(x) < box_half_x + half_x && simd::abs(y) < box_half_y + half_y &&
                     simd::abs(along_x * y - along_y * x) <= across_x * box_half_x + across_y * box_half_y + kSlack;
    if (simd::any_of(hit) && visit_lanes(hit, box_index_, i)) return;
  }
}

bool ObstacleField::is_free(const Vec2& point, std::span<const std::size_t> ignored) const {
  return is_free(point, point, ignored);
}

bool ObstacleField::is_free(const Vec2& from, const Vec2& to, std::span<const std::size_t> ignored) const {
  return is_inside(from, bounds_) && is_inside(to, bounds_) && !first_blocker(from, to, ignored);
}

std::optional<ObstacleIndex> ObstacleField::first_blocker(const Vec2& from, const Vec2& to,
                                                          std::span<const std::size_t> ignored) const {
  std::optional<ObstacleIndex> found;
  for_candidates(from, to, [&](ObstacleIndex i) {
    if (is_ignored(i, ignored) || regista::is_free(from, to, obstacles_[i])) return false;
    found = i;
    return true;
  });
  return found;
}

void ObstacleField::blockers(const Vec2& from, const Vec2& to, std::vector<ObstacleIndex>& out) const {
  for_candidates(from, to, [&](ObstacleIndex i) {
    if (!regista::is_free(from, to, obstacles_[i])) out.push_back(i);
    return false;
  });
}

void ObstacleField::covering(const Vec2& point, std::vector<ObstacleIndex>& out) const {
  for_candidates(point, point, [&](ObstacleIndex i) {
    if (!regista::is_free(point, obstacles_[i])) out.push_back(i);
    return false;
  });
}

}  // namespace regista
