#include "control/velocity_choice.h"

#include <array>
#include <cmath>
#include <numbers>

#include "control/safety/separation.h"
#include "world_model/types/crash_rule.h"

namespace regista {
namespace {

constexpr int kDirections = 16;
constexpr std::array kSpeeds{1.0, 0.75, 0.5, 0.25};  ///< parts of the speed limit
/// Nearer contacts than this are equally bad; nothing can be changed in one period.
constexpr double kSoonest_s = 0.01;

/// Where it is by then, and how fast it moves.
struct Moved {
  Vec2 position_m, velocity_mps;
};
Moved moved(const Neighbour& neighbour, double after_s, double acceleration_lasts_s) {
  const double lasts_s = std::min(after_s, acceleration_lasts_s);
  const Vec2 gained_mps = lasts_s * neighbour.acceleration_mps2;
  return {neighbour.position_m + after_s * neighbour.velocity_mps + (after_s - lasts_s / 2.0) * gained_mps,
          neighbour.velocity_mps + gained_mps};
}

class Judge {
 public:
  Judge(const SafetyRobot& robot, double until_s, std::span<const Neighbour> neighbours,
        const VelocityChoiceParams& params, double lasts_s)
      : robot_(robot), until_s_(until_s), neighbours_(neighbours), params_(params), lasts_s_(lasts_s) {}

  /// What danger adds to a velocity's cost; stops as soon as that exceeds `bearable`.
  double danger(const Vec2& velocity_mps, double bearable) const {
    double danger = 0.0;
    for (const Neighbour& neighbour : neighbours_) {
      const double contact_s = time_to_contact(robot_.position_m, velocity_mps, neighbour, lasts_s_);
      if (contact_s >= until_s_) continue;
      if (!neighbour.is_opponent) {
        danger = std::max(danger, danger_of(contact_s, params_.weight_m, params_.horizon_s));
      } else {
        const double horizon_s = params_.foul_horizon_s + neighbour.late_s;
        if (contact_s < horizon_s && is_our_foul(velocity_mps, neighbour, contact_s)) {
          danger = std::max(danger, danger_of(contact_s, params_.foul_weight_m, horizon_s));
        }
      }
      if (danger > bearable) break;
    }
    return danger;
  }

 private:
  static double danger_of(double contact_s, double weight_m, double horizon_s) {
    return contact_s < horizon_s ? weight_m * (1.0 / std::max(contact_s, kSoonest_s) - 1.0 / horizon_s) : 0.0;
  }

  bool is_our_foul(const Vec2& velocity_mps, const Neighbour& neighbour, double contact_s) const {
    const Moved then = moved(neighbour, contact_s, lasts_s_);
    const Vec2 apart = then.position_m - robot_.position_m - contact_s * velocity_mps;
    const Vec2 normal = apart.stableNormalized();
    const Fault fault = crash_fault(velocity_mps.dot(normal), -then.velocity_mps.dot(normal));
    return fault == Fault::first || fault == Fault::both;
  }

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
  const Judge judge(robot, arrival_s, neighbours, params, acceleration_lasts_s);
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
