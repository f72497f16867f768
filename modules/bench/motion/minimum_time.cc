#include "modules/bench/motion/minimum_time.h"

#include <Eigen/Dense>
#include <array>
#include <random>
#include <stdexcept>
#include <string>

#include "planning/uniform.h"

namespace regista::bench {
namespace {

using Vec4 = Eigen::Vector4d;

constexpr int kStarts = 400;        // of the search; most states need one to five
constexpr int kSteps = 80;          // of each
constexpr double kRest = 1e-9;      // |v|, |x| of the end where a = 1 and the time about 1: the search has converged
constexpr double kLine = 1e-5;      // |x × v| likewise: off the line by so little changes the time by its square
constexpr double kNearLine = 1e-3;  // likewise: where the search finds nothing, the time along the line does, to 1e-3
constexpr double kSteepest = 30.0;  // sinh(30) = 5e12: a switch as sharp as that is one between full ahead and back
constexpr double kFlat = 0.3;       // below, the closed form would divide small differences

/// An extremal: λ/|λ| = (tanh s, 1/cosh s) in the axis `axis_rad` and to its left, sinh s linear in time.
struct Extremal {
  double axis_rad = 0.0;
  double begin = 0.0;  ///< s at 0
  double end = 0.0;    ///< s at duration_s
  double duration_s = 0.0;
};

struct Impulse {
  Vec2 velocity = Vec2::Zero();  ///< ∫ u dt, in units of a
  Vec2 way = Vec2::Zero();       ///< ∫ (T − t) u dt, likewise
};

/// Gauss-Legendre, five points: for directions that hardly turn.
Impulse flat_impulse(const Extremal& e) {
  constexpr std::array kPlace{0.0469100770306680, 0.2307653449471585, 0.5, 0.7692346550528415, 0.9530899229693320};
  constexpr std::array kWeight{0.1184634425280945, 0.2393143352496832, 0.2844444444444444, 0.2393143352496832,
                               0.1184634425280945};
  Impulse out;
  for (std::size_t i = 0; i < kPlace.size(); ++i) {
    const double w = std::sinh(e.begin) + kPlace.at(i) * (std::sinh(e.end) - std::sinh(e.begin));
    const Vec2 u = Vec2(w, 1.0) / std::hypot(w, 1.0);
    out.velocity += kWeight.at(i) * e.duration_s * u;
    out.way += kWeight.at(i) * (1.0 - kPlace.at(i)) * e.duration_s * e.duration_s * u;
  }
  return out;
}

/// With w = sinh s, dt = dw/k: the integrals of w/√(w²+1), 1/√(w²+1) and w²/√(w²+1) in closed form.
Impulse steep_impulse(const Extremal& e) {
  const double w0 = std::sinh(e.begin);
  const double w1 = std::sinh(e.end);
  const double k = (w1 - w0) / e.duration_s;
  const double zeroth = e.end - e.begin;
  const double first = std::cosh(e.end) - std::cosh(e.begin);
  const double second = (w1 * std::cosh(e.end) - w0 * std::cosh(e.begin) - zeroth) / 2.0;
  return {Vec2(first, zeroth) / k, Vec2(w1 * first - second, w1 * zeroth - first) / (k * k)};
}

Impulse impulse_of(const Extremal& e) {
  const Impulse along = std::abs(e.end - e.begin) < kFlat ? flat_impulse(e) : steep_impulse(e);
  return {rotated(along.velocity, e.axis_rad), rotated(along.way, e.axis_rad)};
}

Extremal extremal_of(const Vec4& z) {
  return {z[0], std::clamp(z[1], -kSteepest, kSteepest), std::clamp(z[2], -kSteepest, kSteepest), z[3]};
}

/// Velocity and place where the extremal ends; x and v in units of a.
Vec4 end_of(const Vec4& z, const Vec2& x, const Vec2& v) {
  const Extremal e = extremal_of(z);
  const Impulse impulse = impulse_of(e);
  Vec4 out;
  out << v + impulse.velocity, x + v * e.duration_s + impulse.way;
  return out;
}

/// Levenberg and Marquardt from one start. True where it ends at rest at the origin.
bool descend(Vec4& z, const Vec2& x, const Vec2& v) {
  constexpr double kDifference = 1e-7;
  double damping = 1e-2;
  Vec4 residual = end_of(z, x, v);
  for (int i = 0; i < kSteps && residual.norm() > kRest; ++i) {
    Eigen::Matrix4d jacobian;
    for (int k = 0; k < 4; ++k) {
      Vec4 moved = z;
      moved[k] += kDifference;
      jacobian.col(k) = (end_of(moved, x, v) - residual) / kDifference;
    }
    const Eigen::Matrix4d normal = jacobian.transpose() * jacobian;
    const Eigen::Matrix4d damped = normal + damping * Eigen::Matrix4d::Identity();
    const Vec4 next = z - damped.ldlt().solve(jacobian.transpose() * residual);
    const Vec4 there = next[3] > 0.0 ? end_of(next, x, v) : Vec4::Constant(1e9);
    if (there.allFinite() && there.norm() < residual.norm()) {
      z = next;
      residual = there;
      damping = std::max(1e-14, damping / 5.0);
    } else {
      damping *= 4.0;
    }
  }
  return residual.norm() <= kRest;
}

/// Everything on one line through the origin, a = 1: full one way, then full the other. With x > 0 or, there, v > 0
/// beyond the stopping curve x = −v|v|/2 back first: t = v + 2·√(v²/2 + x), of which the second part is √(v²/2 + x).
MinimumTime along_line(const Vec2& x, const Vec2& v) {
  const Vec2 line = (x.norm() > v.norm() ? x : v).normalized();
  const double to_stop = x.dot(line) + v.dot(line) * v.norm() / 2.0;
  const Vec2 side = to_stop >= 0.0 ? line : Vec2(-line);
  const double second_s = std::sqrt(std::max(0.0, v.squaredNorm() / 2.0 + x.dot(side)));
  const double first_s = std::max(0.0, v.dot(side) + second_s);
  return {first_s + second_s, -first_s * side, second_s * side};
}

MinimumTime in_time(MinimumTime answer, double unit_s) {
  answer.duration_s *= unit_s;
  return answer;
}

std::string text(const Vec2& value) { return "(" + std::to_string(value.x()) + ", " + std::to_string(value.y()) + ")"; }

}  // namespace

MinimumTime minimum_time(const Vec2& x, const Vec2& v, double a) {
  if (!is_finite(x) || !is_finite(v) || !(a > 0.0)) {
    throw std::invalid_argument("minimum_time from " + text(x) + " m, " + text(v) + " m/s with " + std::to_string(a) +
                                " m/s²");
  }
  const double unit_s = v.norm() / a + 2.0 * std::sqrt(x.norm() / a);  // about the time it takes
  if (unit_s == 0.0) return {};
  const Vec2 place = x / (a * unit_s * unit_s);
  const Vec2 velocity = v / (a * unit_s);
  if (std::abs(cross(place, velocity)) <= kLine) {
    return in_time(along_line(place, velocity), unit_s);
  }
  const Vec2 line = place.norm() > velocity.norm() ? place : velocity;
  const double line_rad = std::atan2(line.y(), line.x());
  std::mt19937_64 random(1);  // of the starts: the same state has the same answer
  for (int i = 0; i < kStarts; ++i) {
    // Every other start is close to a line, ahead first and back then or the other way round.
    const bool near_line = i % 2 == 1;
    const double steepest = near_line ? kSteepest / 2.0 : 3.0;
    const double axis_rad = near_line ? line_rad : uniform(random, -std::numbers::pi, std::numbers::pi);
    Vec4 z(axis_rad, uniform(random, -steepest, steepest), uniform(random, -steepest, steepest),
           uniform(random, 0.5, 1.5));
    if (!descend(z, place, velocity)) continue;
    const Extremal e = extremal_of(z);
    const double scale = std::max(std::cosh(e.begin), std::cosh(e.end));
    return in_time({e.duration_s, rotated(Vec2(std::sinh(e.begin), 1.0) / scale, e.axis_rad),
                    rotated(Vec2(std::sinh(e.end), 1.0) / scale, e.axis_rad)},
                   unit_s);
  }
  // So near to the line the search may not converge, and hardly differs.
  if (std::abs(cross(place, velocity)) <= kNearLine) return in_time(along_line(place, velocity), unit_s);
  throw std::runtime_error("no time-optimal motion found from " + text(x) + " m, " + text(v) + " m/s");
}

double shortfall(const MinimumTime& answer, const Vec2& x, const Vec2& v, double a, double time_s) {
  constexpr int kParts = 20000;
  if (answer.duration_s <= 0.0) return 0.0;
  const Vec2 p = (answer.costate_begin - answer.costate_end) / answer.duration_s;
  double most = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double t = (i + 0.5) / kParts * time_s;
    most += (answer.costate_begin - p * t).norm() * time_s / kParts;
  }
  return -answer.costate_begin.dot(v) - p.dot(x) - a * most;
}

}  // namespace regista::bench
