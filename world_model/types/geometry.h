// Points, poses and twists in the plane, for every layer. Field frame unless a name says body: origin at the centre,
// x towards the goal of the team on the +x side, y left; body frame: x forward, y left. Metres, radians, seconds.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace regista {

using Vec2 = Eigen::Vector2d;

struct Pose {
  Vec2 position_m = Vec2::Zero();
  double heading_rad = 0.0;  ///< of body x in the field frame, in (-π, π]
  bool operator==(const Pose&) const = default;
};

struct Twist {
  Vec2 velocity_mps = Vec2::Zero();
  double angular_radps = 0.0;  ///< positive: counter-clockwise
  bool operator==(const Twist&) const = default;
};

/// The same angle in (-π, π]. The argument must be finite.
inline double wrap_angle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

/// z of the cross product; positive when b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// v turned counter-clockwise. Field to body is rotated(v, -heading), body to field rotated(v, heading).
inline Vec2 rotated(const Vec2& v, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// v, shortened to the given length where it is longer.
inline Vec2 clamped_norm(const Vec2& v, double length_max) {
  const double length = v.norm();
  return length > length_max ? Vec2(v * (length_max / length)) : v;
}

/// The point of segment ab nearest to p; a where the segment has no length.
inline Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double length_squared = ab.squaredNorm();
  if (length_squared == 0.0) return a;
  return a + std::clamp((p - a).dot(ab) / length_squared, 0.0, 1.0) * ab;
}

inline bool is_finite(const Vec2& v) { return std::isfinite(v.x()) && std::isfinite(v.y()); }

}  // namespace regista
