#include "world_model/robot_filter.h"

#include <cmath>

#include "world_model/prediction.h"

namespace regista {
namespace {

AxisFilter start(double value, double sigma, double rate_sigma) {
  return {value, 0.0, sigma * sigma, 0.0, rate_sigma * rate_sigma};
}

double square(double value) { return value * value; }

}  // namespace

RobotFilter::RobotFilter(const Pose& detected, Time captured, const RobotFilterParams& params)
    : x_(start(detected.position_m.x(), params.position_sigma_m, params.speed_sigma_mps)),
      y_(start(detected.position_m.y(), params.position_sigma_m, params.speed_sigma_mps)),
      heading_(start(wrap_angle(detected.heading_rad), params.heading_sigma_rad, params.angular_speed_sigma_radps)),
      time_(captured) {}

void RobotFilter::advance(Time until, const CommandModel& commands, const RobotFilterParams& params) {
  if (until <= time_) return;
  const double dt_s = to_seconds(until - time_);
  RobotState before;  // the modelled robot: where this one is, moving as it should
  before.pose.heading_rad = heading_.value;
  before.twist = response_ ? to_field(*response_, heading_.value) : Twist{Vec2(x_.rate, y_.rate), heading_.rate};
  const bool told = !commands.sent.empty() && commands.sent.front().captured + commands.latency < until;

  regista::advance(x_, dt_s, params.acceleration_density_m2ps3);
  regista::advance(y_, dt_s, params.acceleration_density_m2ps3);
  regista::advance(heading_, dt_s, params.angular_acceleration_density_rad2ps3);
  response_.reset();
  if (told) {
    const RobotState after = predicted(before, time_, until, commands.sent, commands.latency, commands.velocity_lag_s);
    const Vec2 shift = after.pose.position_m - before.twist.velocity_mps * dt_s;
    const Vec2 change = after.twist.velocity_mps - before.twist.velocity_mps;
    x_.value += shift.x();
    y_.value += shift.y();
    x_.rate += change.x();
    y_.rate += change.y();
    heading_.value += after.pose.heading_rad - before.pose.heading_rad - before.twist.angular_radps * dt_s;
    heading_.rate += after.twist.angular_radps - before.twist.angular_radps;
    response_ = to_body(after.twist, after.pose.heading_rad);
  }
  heading_.value = wrap_angle(heading_.value);
  time_ = until;
}

double RobotFilter::distance_m(const Pose& detected, Time captured) const {
  const double delay_s = to_seconds(time_ - captured);
  const Vec2 expected(x_.value - x_.rate * delay_s, y_.value - y_.rate * delay_s);
  return (detected.position_m - expected).norm();
}

bool RobotFilter::accepts(const Pose& detected, Time captured, const RobotFilterParams& params) const {
  const double delay_s = to_seconds(time_ - captured);
  const double sigma_m = std::sqrt(innovation_variance(x_, delay_s, square(params.position_sigma_m)));
  const double sigma_rad = std::sqrt(innovation_variance(heading_, delay_s, square(params.heading_sigma_rad)));
  const double turned = wrap_angle(detected.heading_rad - (heading_.value - heading_.rate * delay_s));
  return distance_m(detected, captured) <= params.gate_m + params.gate_sigmas * sigma_m &&
         std::abs(turned) <= params.gate_rad + params.gate_sigmas * sigma_rad;
}

void RobotFilter::correct(const Pose& detected, Time captured, const RobotFilterParams& params) {
  const double delay_s = to_seconds(time_ - captured);
  const double noise_m2 = square(params.position_sigma_m);
  regista::correct(x_, detected.position_m.x() - (x_.value - x_.rate * delay_s), delay_s, noise_m2);
  regista::correct(y_, detected.position_m.y() - (y_.value - y_.rate * delay_s), delay_s, noise_m2);
  const double turned = wrap_angle(detected.heading_rad - (heading_.value - heading_.rate * delay_s));
  regista::correct(heading_, turned, delay_s, square(params.heading_sigma_rad));
  heading_.value = wrap_angle(heading_.value);
}

RobotState RobotFilter::state(RobotId id, Duration age) const {
  RobotState out;
  out.id = id;
  out.pose = {{x_.value, y_.value}, heading_.value};
  out.twist = {{x_.rate, y_.rate}, heading_.rate};
  out.position_variance_m2 = x_.variance;
  out.velocity_variance_m2ps2 = x_.rate_variance;
  out.heading_variance_rad2 = heading_.variance;
  out.age = age;
  return out;
}

}  // namespace regista
