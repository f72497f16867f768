// What a robot's centre must keep out of: a convex core (point, segment or axis-aligned rectangle) grown by a radius,
// so that disc, capsule and rounded rectangle are one family ("Planning details" of the visibility-sampling paper).
#pragma once

#include "world_model/types/geometry.h"

namespace regista {

/// No coordinate or radius may be larger: squares must stay far from where single precision ends (3e38).
inline constexpr double kLargest_m = 1e9;

enum class Core { point, segment, rectangle };

/// The open set {p : signed distance(p, core) < radius_m} is forbidden, its boundary is free. The signed distance is
/// negative within a rectangle, minus the distance to its nearest side, and never negative for a point or segment: with
/// radius 0 a rectangle still forbids its interior, a disc or capsule (or a rectangle without area) nothing.
struct Obstacle {
  Core core = Core::point;
  Vec2 a = Vec2::Zero();  ///< point: the centre; segment: one end; rectangle: the corner with the smaller coordinates
  Vec2 b = Vec2::Zero();  ///< point: the same centre; segment: the other end; rectangle: the opposite corner
  double radius_m = 0.0;  ///< >= 0, the moving robot's radius and margin included
  bool operator==(const Obstacle&) const = default;
};

inline Obstacle disc(const Vec2& centre, double radius_m) { return {Core::point, centre, centre, radius_m}; }

inline Obstacle capsule(const Vec2& a, const Vec2& b, double radius_m) { return {Core::segment, a, b, radius_m}; }

/// Corners may come in any order.
inline Obstacle rounded_rectangle(const Vec2& corner, const Vec2& opposite, double radius_m) {
  return {Core::rectangle, corner.cwiseMin(opposite), corner.cwiseMax(opposite), radius_m};
}

/// True when no number is larger than kLargest_m, all are numbers, and the radius is not negative.
inline bool is_valid(const Obstacle& obstacle) {
  const double largest_m =
      std::max(obstacle.a.cwiseAbs().cwiseMax(obstacle.b.cwiseAbs()).maxCoeff(), obstacle.radius_m);
  // A sum keeps what is not a number; a maximum may lose it.
  const double sum = (obstacle.a + obstacle.b).sum();
  return largest_m <= kLargest_m && sum == sum && obstacle.radius_m >= 0.0;
}

/// True when a rectangle's core holds the other's and its radius is not smaller: then all of the other lies inside.
inline bool surely_holds(const Obstacle& rectangle, const Obstacle& other) {
  if (rectangle.core != Core::rectangle || other.radius_m > rectangle.radius_m) return false;
  return std::min(other.a.x(), other.b.x()) >= rectangle.a.x() &&
         std::max(other.a.x(), other.b.x()) <= rectangle.b.x() &&
         std::min(other.a.y(), other.b.y()) >= rectangle.a.y() && std::max(other.a.y(), other.b.y()) <= rectangle.b.y();
}

}  // namespace regista
