#include "world_model/prediction.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

using Complex = std::complex<double>;  // a vector of the plane, x + i y: turning is multiplying

/// Largest error of the heading inside a step that takes the rate as constant.
constexpr double kHeadingError_rad = 1e-4;
/// Bounds the work for absurd rates: 10³ steps for 10 rad/s of change hold kHeadingError_rad beyond a second.
constexpr double kStepsMax = 1000.0;

struct Motion {
  Complex position;
  Complex velocity;
  double heading = 0.0;  // not wrapped
  double rate = 0.0;
};

/// ∫ e^{i w s} ds over [0, t] = t e^{i w t / 2} sin(w t / 2) / (w t / 2).
Complex turned_integral(double w, double t) {
  const double x = w * t / 2.0;
  // Below 10⁻⁴ the next term of the series, x⁴/120, is under the rounding of 1.
  const double sinc = std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
  return std::polar(t * sinc, x);
}

/// One step over t with the command u (body frame) while the heading turns at the constant rate w, solved in the plane
/// of complex numbers: v' = (u e^{i(heading + w s)} − v) / lag has the solution v = A e^{i w s} + (v₀ − A) e^{−s/lag}
/// with A = u e^{i heading} / (1 + i w lag).
void turn_and_move(Motion& m, Complex u, double w, double t, double lag_s) {
  const Complex wanted = u * std::polar(1.0, m.heading);
  const Complex steady = wanted / Complex(1.0, w * lag_s);
  const double decay = lag_s > 0.0 ? std::exp(-t / lag_s) : 0.0;
  m.position += steady * turned_integral(w, t) + (m.velocity - steady) * (lag_s * (1.0 - decay));
  m.velocity = steady * std::polar(1.0, w * t) + (m.velocity - steady) * decay;
}

/// How many steps keep the heading inside each, taken as linear, within kHeadingError_rad: over a step h the rate
/// changes by at most |gap| h / lag, and a parabola leaves its chord by change · h / 8.
int steps_for(double rate_gap, double t, double lag_s) {
  if (lag_s <= 0.0 || rate_gap == 0.0) return 1;
  const double step = std::sqrt(8.0 * kHeadingError_rad * lag_s / std::abs(rate_gap));
  return static_cast<int>(std::clamp(std::ceil(t / step), 1.0, kStepsMax));
}

void follow(Motion& m, const BodyVelocity& command, double t, double lag_s) {
  const Complex u(command.forward_mps, command.left_mps);
  // Without translation the heading does not matter: one step is exact.
  const int steps = u == 0.0 ? 1 : steps_for(m.rate - command.angular_radps, t, lag_s);
  const double h = t / steps;
  const double decay = lag_s > 0.0 ? std::exp(-h / lag_s) : 0.0;
  for (int i = 0; i < steps; ++i) {
    const double gap = m.rate - command.angular_radps;
    const double turned = command.angular_radps * h + gap * lag_s * (1.0 - decay);
    turn_and_move(m, u, turned / h, h, lag_s);
    m.heading += turned;
    m.rate = command.angular_radps + gap * decay;
  }
}

void coast(Motion& m, double t) {
  m.position += m.velocity * t;
  m.heading += m.rate * t;
}

void check(Time state_time, Time until, std::span<const SentVelocity> sent, double lag_s) {
  if (until < state_time) {
    throw std::invalid_argument("prediction to " + std::to_string(to_us(until)) + " us lies before the state's " +
                                std::to_string(to_us(state_time)) + " us");
  }
  if (!(lag_s >= 0.0) || !std::isfinite(lag_s)) {
    throw std::invalid_argument("velocity lag of " + std::to_string(lag_s) + " s");
  }
  const auto earlier = [](const SentVelocity& a, const SentVelocity& b) { return a.captured < b.captured; };
  const auto late = std::is_sorted_until(sent.begin(), sent.end(), earlier);
  if (late != sent.end()) {
    throw std::invalid_argument("commands are not sorted: one captured at " + std::to_string(to_us(late->captured)) +
                                " us comes after a later one");
  }
}

}  // namespace

RobotState predicted(const RobotState& robot, Time state_time, Time until, std::span<const SentVelocity> sent,
                     Duration latency, double velocity_lag_s) {
  check(state_time, until, sent, velocity_lag_s);
  Motion m{{robot.pose.position_m.x(), robot.pose.position_m.y()},
           {robot.twist.velocity_mps.x(), robot.twist.velocity_mps.y()},
           robot.pose.heading_rad,
           robot.twist.angular_radps};
  const Time first_acts = sent.empty() ? until : sent.front().captured + latency;
  Time now = std::clamp(first_acts, state_time, until);
  coast(m, to_seconds(now - state_time));
  for (std::size_t i = 0; i < sent.size() && now < until; ++i) {
    const Time end = i + 1 < sent.size() ? std::min(sent[i + 1].captured + latency, until) : until;
    if (end <= now) continue;
    follow(m, sent[i].velocity, to_seconds(end - now), velocity_lag_s);
    now = end;
  }
  RobotState out = robot;
  out.pose = {{m.position.real(), m.position.imag()}, wrap_angle(m.heading)};
  out.twist = {{m.velocity.real(), m.velocity.imag()}, m.rate};
  return out;
}

BallState predicted(const BallState& ball, Duration ahead, double deceleration_mps2) {
  if (ahead < Duration::zero() || !(deceleration_mps2 >= 0.0)) {
    throw std::invalid_argument("ball prediction over " + std::to_string(ahead.count()) +
                                " us with a deceleration of " + std::to_string(deceleration_mps2) + " m/s2");
  }
  BallState out = ball;
  const double speed = ball.velocity_mps.norm();
  if (speed == 0.0) return out;
  const double t = to_seconds(ahead);
  if (deceleration_mps2 * t >= speed) {  // rests: v² / 2a further on
    out.position_m += ball.velocity_mps * (speed / (2.0 * deceleration_mps2));
    out.velocity_mps = Vec2::Zero();
    return out;
  }
  out.position_m += ball.velocity_mps * (t - deceleration_mps2 * t * t / (2.0 * speed));
  out.velocity_mps *= 1.0 - deceleration_mps2 * t / speed;
  return out;
}

}  // namespace regista
