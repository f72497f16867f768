#include "planning/graph/samples.h"

#include <algorithm>
#include <array>

namespace regista::graph {
namespace {

/// Samples stand off by this share more than needed, so that rounding does not hide neighbours from each other.
constexpr double kStandOff = 1.0 + 1e-9;

constexpr double kHalfSqrt2 = std::numbers::sqrt2 / 2.0;

/// Unit vectors 45° apart, written out so that mirror images are exact; every second one for four samples.
constexpr std::array<std::array<double, 2>, kSamplesNear> kDirections{{{1.0, 0.0},
                                                                       {kHalfSqrt2, kHalfSqrt2},
                                                                       {0.0, 1.0},
                                                                       {-kHalfSqrt2, kHalfSqrt2},
                                                                       {-1.0, 0.0},
                                                                       {-kHalfSqrt2, -kHalfSqrt2},
                                                                       {0.0, -1.0},
                                                                       {kHalfSqrt2, -kHalfSqrt2}}};

/// 1/cos(π/n): the circle around a regular polygon against the circle within.
constexpr double kReachFar = std::numbers::sqrt2;
constexpr double kReachNear = 1.0823922002923938;

bool is_near_another(const ObstacleField& field, ObstacleIndex index, std::span<const ObstacleIndex> neighbours) {
  const Obstacle& obstacle = field.obstacles()[index];
  return std::any_of(neighbours.begin(), neighbours.end(), [&](ObstacleIndex other) {
    return other != index && gap(obstacle, field.obstacles()[other]) <= kNear_m;
  });
}

/// Around one end of the obstacle's core, which is both ends for a disc.
void append_circle(const Obstacle& obstacle, const Vec2& centre, bool near, const Bounds& bounds,
                   std::vector<Vec2>& out) {
  const std::size_t step = near ? 1 : kSamplesNear / kSamplesFar;
  const double reach_m = obstacle.radius_m * (near ? kReachNear : kReachFar) * kStandOff;
  for (std::size_t k = 0; k < kDirections.size(); k += step) {
    const Vec2 sample = centre + reach_m * Vec2(kDirections[k][0], kDirections[k][1]);
    if (is_inside(sample, bounds) && is_free(sample, obstacle)) out.push_back(sample);
  }
}

void append_corners(const Obstacle& obstacle, const Bounds& bounds, std::vector<Vec2>& out) {
  const Vec2 grow = Vec2::Constant(obstacle.radius_m * kStandOff);
  const Vec2 low = obstacle.a - grow;
  const Vec2 high = obstacle.b + grow;
  for (const Vec2& corner : {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}) {
    if (is_inside(corner, bounds)) out.push_back(corner);
  }
}

double box_gap(const Obstacle& one, const Obstacle& other) {
  const Vec2 apart = (one.a - other.b).cwiseMax(other.a - one.b);
  return apart.cwiseMax(0.0).norm() + std::min(apart.maxCoeff(), 0.0) - one.radius_m - other.radius_m;
}

}  // namespace

std::size_t samples_max(const Obstacle& obstacle) {
  switch (obstacle.core) {
    case Core::point:
      return kSamplesNear;
    case Core::segment:
      return kSamplesMax;
    case Core::rectangle:
      break;
  }
  return 4;
}

double samples_reach_m(double radius_m) {
  // A disc's sample stands off by the most where there are few; so does a rectangle's corner.
  constexpr double kRounding = 1.0 + 1e-6;
  return std::max(kNear_m, (kReachFar - 1.0) * radius_m) * kRounding;
}

void append_samples(const ObstacleField& field, ObstacleIndex index, std::vector<Vec2>& out) {
  std::vector<ObstacleIndex> neighbours;
  field.visit_maybe_near(index, samples_reach_m(field.obstacles()[index].radius_m),
                         [&](ObstacleIndex i) { neighbours.push_back(i); });
  append_samples(field, index, neighbours, out);
}

void append_samples(const ObstacleField& field, ObstacleIndex index, std::span<const ObstacleIndex> neighbours,
                    std::vector<Vec2>& out) {
  const Obstacle& obstacle = field.obstacles()[index];
  if (obstacle.core == Core::rectangle) {
    append_corners(obstacle, field.bounds(), out);
    return;
  }
  const bool near = is_near_another(field, index, neighbours);
  append_circle(obstacle, obstacle.a, near, field.bounds(), out);
  if (obstacle.core == Core::segment) append_circle(obstacle, obstacle.b, near, field.bounds(), out);
}

double gap(const Obstacle& one, const Obstacle& other) {
  if (one.core != Core::rectangle) return clearance(one.a, one.b, other) - one.radius_m;
  if (other.core != Core::rectangle) return clearance(other.a, other.b, one) - other.radius_m;
  return box_gap(one, other);
}

}  // namespace regista::graph
