#include "control/bang_bang.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace regista {
namespace {

/// Halvings of the angle that divides the limits: to 0.1°, below which the duration changes by less than 0.1 %.
constexpr int kHalvings = 10;
constexpr int kRotations = 4;
/// The sine of the angle between way and velocity within which a drive counts as straight: 6°, about what bang-bang
/// drives correct within a few ticks.
constexpr double kStraight = 0.1;

/// One axis, turned so that the motion ends towards the positive side.
struct Approach {
  double sign = 1.0;
  double distance = 0.0;  ///< >= the braking distance
  double velocity = 0.0;  ///< may be negative: first it turns round
};

Approach approach_of(double distance, double velocity, const AxisLimits& limits) {
  const double stopping = velocity * std::abs(velocity) / (2.0 * limits.braking);
  return distance >= stopping ? Approach{1.0, distance, velocity} : Approach{-1.0, -distance, -velocity};
}

/// Speeds up from `velocity` in [0, peak], cruises, brakes.
struct Trapezoid {
  double turn_s = 0.0;  ///< braking to a stand first, because it goes the wrong way
  double start = 0.0;   ///< velocity after that
  double peak = 0.0;
  double up_s = 0.0;  ///< from start to peak; slowing down where the start is above the speed limit
  double cruise_s = 0.0;
  double down_s = 0.0;
};

Trapezoid trapezoid(const Approach& approach, const AxisLimits& limits) {
  Trapezoid out;
  double distance = approach.distance;
  out.start = approach.velocity;
  if (out.start < 0.0) {
    out.turn_s = -out.start / limits.braking;
    distance += out.start * out.start / (2.0 * limits.braking);
    out.start = 0.0;
  }
  const double a = limits.acceleration;
  const double b = limits.braking;
  const double squared = (2.0 * a * b * distance + b * out.start * out.start) / (a + b);
  out.peak = std::max(out.start, std::sqrt(std::max(0.0, squared)));
  if (out.peak > limits.speed_max) {
    out.peak = limits.speed_max;
    const double rate = out.start > out.peak ? b : a;
    out.up_s = std::abs(out.peak - out.start) / rate;
    const double up = out.up_s * (out.start + out.peak) / 2.0;
    const double down = out.peak * out.peak / (2.0 * b);
    out.cruise_s = std::max(0.0, distance - up - down) / out.peak;
  } else {
    out.up_s = (out.peak - out.start) / a;
  }
  out.down_s = out.peak / b;
  return out;
}

double duration(const Trapezoid& t) { return t.turn_s + t.up_s + t.cruise_s + t.down_s; }

AxisLimits part(const RobotLimits& limits, double share) {
  return {share * limits.acceleration_max_mps2, share * limits.braking_max_mps2, share * limits.speed_max_mps};
}

struct Division {
  double x_share = 1.0;
  double y_share = 1.0;
  double duration_s = 0.0;
};

/// More for x makes x faster and y slower, so the angle at which both take equally long is found by halving.
Division divide(const Vec2& way_m, const Vec2& velocity_mps, const RobotLimits& x_limits, const RobotLimits& y_limits) {
  double low = 1e-3;
  double high = std::numbers::pi / 2.0 - 1e-3;
  Division out;
  for (int i = 0; i < kHalvings; ++i) {
    const double angle = (low + high) / 2.0;
    out.x_share = std::cos(angle);
    out.y_share = std::sin(angle);
    const double x_s = bang_bang_duration(way_m.x(), velocity_mps.x(), part(x_limits, out.x_share));
    const double y_s = bang_bang_duration(way_m.y(), velocity_mps.y(), part(y_limits, out.y_share));
    out.duration_s = std::max(x_s, y_s);
    (x_s < y_s ? low : high) = angle;
  }
  return out;
}

/// Braking harder than speeding up is for slowing down along the velocity, which turns towards the way: for the axis
/// that has most of the way.
RobotLimits across_limits(const RobotLimits& limits) {
  RobotLimits out = limits;
  out.braking_max_mps2 = std::min(limits.braking_max_mps2, limits.acceleration_max_mps2);
  return out;
}

/// Both axes of one rotation, the same duration for both.
struct Drive {
  double duration_s = std::numeric_limits<double>::infinity();
  Vec2 next_mps = Vec2::Zero();
};

void take_faster(Drive& best, const Vec2& axis, const Vec2& way_m, const Vec2& velocity_mps, const RobotLimits& limits,
                 double dt_s) {
  const Vec2 left(-axis.y(), axis.x());
  const bool along = std::abs(way_m.dot(axis)) >= std::abs(way_m.dot(left));
  const Vec2 x_axis = along ? axis : left;
  const Vec2 y_axis(-x_axis.y(), x_axis.x());
  const Vec2 way(way_m.dot(x_axis), way_m.dot(y_axis));
  const Vec2 velocity(velocity_mps.dot(x_axis), velocity_mps.dot(y_axis));
  const RobotLimits y_limits = across_limits(limits);
  const Division division = divide(way, velocity, limits, y_limits);
  if (division.duration_s >= best.duration_s) return;
  best.duration_s = division.duration_s;
  best.next_mps = bang_bang_velocity(way.x(), velocity.x(), part(limits, division.x_share), dt_s) * x_axis +
                  bang_bang_velocity(way.y(), velocity.y(), part(y_limits, division.y_share), dt_s) * y_axis;
}

}  // namespace

double bang_bang_duration(double distance, double velocity, const AxisLimits& limits) {
  return duration(trapezoid(approach_of(distance, velocity, limits), limits));
}

double bang_bang_velocity(double distance, double velocity, const AxisLimits& limits, double dt_s) {
  const Approach approach = approach_of(distance, velocity, limits);
  const Trapezoid t = trapezoid(approach, limits);
  const double after_turn_s = dt_s - t.turn_s;
  const double after_up_s = after_turn_s - t.up_s;
  const double after_cruise_s = after_up_s - t.cruise_s;
  double next = 0.0;
  if (after_turn_s < 0.0) {
    next = approach.velocity + dt_s * limits.braking;
  } else if (after_up_s < 0.0) {
    next = t.start + (t.peak - t.start) * after_turn_s / t.up_s;
  } else if (after_cruise_s < 0.0) {
    next = t.peak;
  } else {
    next = std::max(0.0, t.peak - limits.braking * after_cruise_s);
  }
  return approach.sign * next;
}

Vec2 bang_bang_velocity(const Vec2& way_m, const Vec2& velocity_mps, const RobotLimits& limits, double dt_s) {
  if (way_m.isZero(0.0) && velocity_mps.isZero(0.0)) return Vec2::Zero();
  Drive best;
  for (int i = 0; i < kRotations; ++i) {
    // Axes fixed in the field: turned with the way, no tick would find the plan of the tick before among its own, and
    // drives would take 5 % longer.
    take_faster(best, rotated(Vec2::UnitX(), i * std::numbers::pi / (2.0 * kRotations)), way_m, velocity_mps, limits,
                dt_s);
  }
  // Along a straight drive the way's own axis does not turn either, and the harder braking is all of use.
  const double length_m = way_m.norm();
  if (length_m > 0.0 && std::abs(cross(way_m, velocity_mps)) <= kStraight * length_m * velocity_mps.norm()) {
    take_faster(best, way_m / length_m, way_m, velocity_mps, limits, dt_s);
  }
  return best.next_mps;
}

}  // namespace regista
