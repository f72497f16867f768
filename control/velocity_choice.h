// From the velocity that the path asks for to one that does not run into moving neighbours soon: sampled velocities
// judged by what they give up and by the time to the first contact. Not a safety layer (safety/ is), but what keeps
// robots from having to use it.
#pragma once

#include <span>

#include "control/safety/safety_params.h"
#include "control/safety/safety_robot.h"

namespace regista {

struct VelocityChoiceParams {
  double horizon_s = 0.7;  ///< contacts with team-mates later than this do not count; 0: none do
  double weight_m = 0.2;   ///< what one more 1/s of 1/(time to contact) costs, m/s per 1/s
  /// The same for crashes with opponents that would be our foul; to keep out of their way otherwise is left to the
  /// safety search, which does it later and so gives less away. Rather near and weighty than far and light: without
  /// delays 0.7 s with 1 m drives half a percent fewer targets, with as many fouls. Both horizons 0: wanted velocities
  /// are taken as they are.
  double foul_horizon_s = 0.5;
  double foul_weight_m = 3.0;
  /// What is seen late has to be dodged earlier: by so much longer is the horizon of fouls with those that drive, per
  /// second of delay, the drive's lag included. With the 60 ms of preset noisy it takes a third of the collisions with
  /// seven crossing obstacles away.
  double foul_horizon_per_delay = 8.0;
  bool operator==(const VelocityChoiceParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("horizon_s", self.horizon_s, Range{0.0, 10.0}, "s", "contacts of team-mates later than this do not count");
    v("weight_m", self.weight_m, Range{0.0, 100.0}, "m", "metres per second given up for 1/s of 1/(time to contact)");
    v("foul_horizon_s", self.foul_horizon_s, Range{0.0, 10.0}, "s",
      "the same for crashes with opponents that would be our foul");
    v("foul_horizon_per_delay", self.foul_horizon_per_delay, Range{0.0, 100.0}, "s/s",
      "by so much per second of delay fouls with those that drive are looked for further ahead");
    v("foul_weight_m", self.foul_weight_m, Range{0.0, 100.0}, "m", "metres per second given up for 1/s of that");
  }
};

/// One that may get in the way. Its velocity changes at a constant rate for a while, then no more.
struct Neighbour {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  Vec2 acceleration_mps2 = Vec2::Zero();
  double gap_m = 0.0;        ///< between centres
  bool is_opponent = false;  ///< a crash with it may be a foul
  double late_s = 0.0;       ///< by so much further ahead than foul_horizon_s a foul with it counts, >= 0
};

/// Seconds until two discs with gap_m between centres touch when `from` holds `velocity_mps`; infinite for never. While
/// the acceleration lasts its mean velocity stands for the neighbour's. 0 when they overlap and approach.
double time_to_contact(const Vec2& from_m, const Vec2& velocity_mps, const Neighbour& neighbour,
                       double acceleration_lasts_s);

/// The best of 82 velocities for a robot among neighbours: least |v − wanted| + weight·(1/ttc − 1/horizon), of all
/// contacts the worst. Of opponents only crashes count that would be our foul, with weight and horizon of their own.
/// `arrival_s`: when it will stand anyway, contacts later than that do not count.
Vec2 choose_velocity(const SafetyRobot& robot, double arrival_s, std::span<const Neighbour> neighbours,
                     const VelocityChoiceParams& params, double acceleration_lasts_s);

}  // namespace regista
