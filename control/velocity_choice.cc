#include "control/velocity_choice.h"

#include <array>
#include <cmath>
#include <numbers>

#include "control/safety/separation.h"

namespace regista {
namespace {

constexpr int kDirections = 16;
constexpr std::array kSpeeds{1.0, 0.75, 0.5, 0.25};  ///< parts of the speed limit
/// Nearer contacts than this are equally bad; nothing can be changed in one period.
constexpr double kSoonest_s = 0.01;

/// When a point at `apart_m` that moves with `velocity_mps` comes within gap_m of the origin.
double time_to_disc(const Vec2& apart_m, const Vec2& velocity_mps, double gap_m) {
  const double approach = -apart_m.dot(velocity_mps);
  if (approach <= 0.0) return kNever;
  const double excess = apart_m.squaredNorm() - gap_m * gap_m;
  if (excess <= 0.0) return 0.0;
  const double speed2 = velocity_mps.squaredNorm();
  const double discriminant = approach * approach - speed2 * excess;
  if (discriminant < 0.0) return kNever;
  return (approach - std::sqrt(discriminant)) / speed2;
}

class Judge {
 public:
  Judge(const SafetyRobot& robot, double until_s, std::span<const Neighbour> neighbours,
        const VelocityChoiceParams& params, double lasts_s)
      : robot_(robot), until_s_(until_s), neighbours_(neighbours), params_(params), lasts_s_(lasts_s) {}

  /// What danger adds to a velocity's cost; stops as soon as that exceeds `bearable`.
  double danger(const Vec2& velocity_mps, double bearable) const {
    double soonest_s = until_s_;
    double danger = 0.0;
    for (const Neighbour& neighbour : neighbours_) {
      const double contact_s = time_to_contact(robot_.position_m, velocity_mps, neighbour, lasts_s_);
      if (contact_s >= soonest_s) continue;
      soonest_s = contact_s;
      danger = params_.weight_m * (1.0 / std::max(contact_s, kSoonest_s) - 1.0 / params_.horizon_s);
      if (danger > bearable) break;
    }
    return danger;
  }

 private:
  const SafetyRobot& robot_;
  double until_s_;
  std::span<const Neighbour> neighbours_;
  const VelocityChoiceParams& params_;
  double lasts_s_;
};

}  // namespace

double time_to_contact(const Vec2& from_m, const Vec2& velocity_mps, const Neighbour& neighbour,
                       double acceleration_lasts_s) {
  const Vec2 apart = from_m - neighbour.position_m;
  if (neighbour.acceleration_mps2.isZero(0.0)) {
    return time_to_disc(apart, velocity_mps - neighbour.velocity_mps, neighbour.gap_m);
  }
  const Vec2 meanwhile =
      velocity_mps - neighbour.velocity_mps - (acceleration_lasts_s / 2.0) * neighbour.acceleration_mps2;
  const double first_s = time_to_disc(apart, meanwhile, neighbour.gap_m);
  if (first_s <= acceleration_lasts_s) return first_s;
  const Vec2 later = velocity_mps - neighbour.velocity_mps - acceleration_lasts_s * neighbour.acceleration_mps2;
  return acceleration_lasts_s + time_to_disc(apart + acceleration_lasts_s * meanwhile, later, neighbour.gap_m);
}

Vec2 choose_velocity(const SafetyRobot& robot, double arrival_s, std::span<const Neighbour> neighbours,
                     const VelocityChoiceParams& params, double acceleration_lasts_s) {
  const double until_s = std::min(params.horizon_s, arrival_s);
  const Judge judge(robot, until_s, neighbours, params, acceleration_lasts_s);
  Vec2 best = robot.wanted_mps;
  double least = judge.danger(best, kNever);
  if (least == 0.0) return best;
  const auto consider = [&](const Vec2& velocity_mps) {
    const double given_up = (velocity_mps - robot.wanted_mps).norm();
    if (given_up >= least) return;
    const double cost = given_up + judge.danger(velocity_mps, least - given_up);
    if (cost >= least) return;
    least = cost;
    best = velocity_mps;
  };
  consider(Vec2::Zero());
  consider(robot.velocity_mps);
  const Vec2 ahead = robot.wanted_mps.isZero(0.0) ? Vec2(Vec2::UnitX()) : Vec2(robot.wanted_mps.normalized());
  for (int i = 0; i < kDirections; ++i) {
    const Vec2 direction = rotated(ahead, 2.0 * std::numbers::pi * i / kDirections);
    for (const double speed : kSpeeds) consider(speed * robot.speed_max_mps * direction);
    // As fast as wanted: of a robot that sets out beside another, all others would cost more than standing for ever.
    consider(robot.wanted_mps.norm() * direction);
  }
  return best;
}

}  // namespace regista
