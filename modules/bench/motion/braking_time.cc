#include "modules/bench/motion/braking_time.h"

#include <Eigen/Dense>
#include <array>
#include <stdexcept>

#include "modules/bench/motion/minimum_time.h"

namespace regista::bench {
namespace {

using Vec4 = Eigen::Vector4d;
using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Of the integration: the second where a turn of the control is too sharp for the first.
constexpr std::array kSteps{400, 4000};
constexpr double kBegin = 0.02;    // τ = T·s²: from there on, where the series at rest still holds
constexpr int kStages = 4;         // of the continuation from braking a to b
constexpr int kIterations = 40;    // of each
constexpr double kFound = 1e-6;    // m and m/s off the state
constexpr double kStopped = 1e-9;  // m/s, below which a velocity has no direction

/// Backward from rest: position, velocity, costate.
struct Backward {
  Vec2 p;
  double a, b;

  Vec6 operator()(const Vec6& y) const {
    const Vec2 v = y.segment<2>(2);
    const Vec2 costate = y.segment<2>(4);
    const double speed = std::max(v.norm(), kStopped);
    const Vec2 ahead = v / speed;
    const Vec2 left(-ahead.y(), ahead.x());
    const double l = costate.dot(ahead);
    const double c = costate.dot(left);
    Vec6 out;
    if (l >= 0.0) {
      out << -v, -a * costate / std::max(costate.norm(), kStopped), p;
      return out;
    }
    const double h = std::sqrt(b * b * l * l + a * a * c * c);
    const Vec2 u = (b * b * l * ahead + a * a * c * left) / h;
    out << -v, -u, p + (b * b - a * a) * l * c / h / speed * left;
    return out;
  }
};

/// What is searched for: the direction of the last motion, p, and the time.
struct Unknowns {
  double direction_rad;
  Vec2 p;
  double duration_s;
};

Unknowns unknowns_of(const Vec4& z) { return {z[0], {z[1], z[2]}, z[3]}; }

/// Position and velocity that the extremal begins with.
Vec4 begin_of(const Unknowns& unknowns, double a, double b, int steps) {
  const Vec2 e = rotated({1.0, 0.0}, unknowns.direction_rad);
  const Vec2 n(-e.y(), e.x());
  const double first_s = unknowns.duration_s * kBegin * kBegin;
  Vec6 y;
  y << -b / 2.0 * first_s * first_s * e, b * first_s * e,
      -e + first_s * (unknowns.p.dot(e) * e + unknowns.p.dot(n) / 2.0 * n);
  const Backward slope{unknowns.p, a, b};
  const double ds = (1.0 - kBegin) / steps;
  for (int i = 0; i < steps; ++i) {  // Runge and Kutta, in s
    const double s = kBegin + i * ds;
    const auto rate = [&](double at, const Vec6& state) -> Vec6 {
      return 2.0 * unknowns.duration_s * at * slope(state);
    };
    const Vec6 k1 = rate(s, y);
    const Vec6 k2 = rate(s + ds / 2.0, y + ds / 2.0 * k1);
    const Vec6 k3 = rate(s + ds / 2.0, y + ds / 2.0 * k2);
    const Vec6 k4 = rate(s + ds, y + ds * k3);
    y += ds / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return y.head<4>();
}

/// Levenberg and Marquardt. True where the extremal begins at the state.
bool search(Vec4& z, const Vec4& state, double a, double b, int steps) {
  constexpr double kDifference = 1e-6;
  const auto miss = [&](const Vec4& at) -> Vec4 {
    return at[3] > 0.0 ? Vec4(begin_of(unknowns_of(at), a, b, steps) - state) : Vec4::Constant(1e9);
  };
  Vec4 residual = miss(z);
  double damping = 1e-4;
  for (int i = 0; i < kIterations && residual.norm() > kFound; ++i) {
    Eigen::Matrix4d jacobian;
    for (int k = 0; k < 4; ++k) {
      Vec4 moved = z;
      moved[k] += kDifference;
      jacobian.col(k) = (miss(moved) - residual) / kDifference;
    }
    const Eigen::Matrix4d normal = jacobian.transpose() * jacobian + damping * Eigen::Matrix4d::Identity();
    const Vec4 next = z - normal.ldlt().solve(jacobian.transpose() * residual);
    const Vec4 there = miss(next);
    if (there.allFinite() && there.norm() < residual.norm()) {
      z = next;
      residual = there;
      damping = std::max(1e-12, damping / 5.0);
    } else {
      damping *= 4.0;
    }
  }
  return residual.norm() <= kFound;
}

}  // namespace

std::optional<double> braking_time(const Vec2& x, const Vec2& v, double a, double b) {
  if (!(b >= a)) throw std::invalid_argument("braking " + std::to_string(b) + " m/s² below " + std::to_string(a));
  const MinimumTime disc = minimum_time(x, v, a);
  if (disc.duration_s == 0.0) return 0.0;
  const double scale = disc.costate_end.norm();
  const Vec2 p = (disc.costate_begin - disc.costate_end) / (disc.duration_s * scale);
  const Vec4 first(std::atan2(-disc.costate_end.y(), -disc.costate_end.x()), p.x(), p.y(), disc.duration_s);
  Vec4 state;
  state << x, v;
  for (const int steps : kSteps) {
    Vec4 z = first;
    int stage = 0;
    while (stage <= kStages && search(z, state, a, a + (b - a) * stage / kStages, steps)) ++stage;
    if (stage > kStages) return z[3];
  }
  return std::nullopt;
}

}  // namespace regista::bench
