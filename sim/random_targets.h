// The main job's task for one team: every robot gets a new random target, far away, as soon as it has arrived.
#pragma once

#include <cstdint>
#include <map>

#include "planning/targets.h"
#include "sim/random.h"
#include "world_model/types/field.h"
#include "world_model/types/world_state.h"

namespace regista {

struct RandomTargetsParams {
  double distance_min_m = 3.0;  ///< from the robot to its new target
  double arrival_m = 0.05;
  double target_gap_m = 0.5;   ///< between targets of the team
  double area_margin_m = 0.1;  ///< between a robot on its target and a defence area
  double robot_radius_m = 0.09;
  double speed_max_mps = 3.0;
  double give_up_s = 5.0;  ///< a robot that gets no nearer for so long gets another target; 0: never
  bool operator==(const RandomTargetsParams&) const = default;
};

/// True when a robot may be sent to that point: inside the field lines and outside both defence areas with its whole
/// body, the margin beside.
bool is_target_place(const Vec2& point_m, const FieldGeometry& field, const RandomTargetsParams& params);

/// Throws std::invalid_argument when there is a place on that field from which too few target places are at least
/// distance_min_m away to be found by drawing.
void require_far_places(const FieldGeometry& field, const RandomTargetsParams& params);

class RandomTargets {
 public:
  /// Throws std::invalid_argument as require_far_places does, or when a number makes no sense.
  RandomTargets(Team team, const FieldGeometry& field, const RandomTargetsParams& params, std::uint64_t seed);

  /// Looks where the team's robots are by the estimate and gives new targets to those that are new, have arrived, or
  /// have given up: targets of two opponents may lie so close together that each one's body covers the other's. A robot
  /// that is not in the world keeps its target; one for which no place was found keeps it too and is tried again half a
  /// second later. sequence and captured change only when a target does.
  const Targets& update(const WorldState& world);

  std::int64_t reached() const;
  std::int64_t reached(std::uint16_t robot) const;

 private:
  struct Assignment {
    Target target;
    bool counted = true;     // arrival at it
    double nearest_m = 0.0;  // to the target so far
    Time nearest_at{};
    Time next_try{};  // of a new target, after none was found
    std::int64_t reached = 0;
  };
  bool has_given_up(Assignment& assignment, const Vec2& robot_position_m, Time now) const;
  bool assign(Assignment& assignment, const Vec2& robot_position_m, Time now);
  bool draw(Assignment& assignment, const Vec2& robot_position_m);
  bool keeps_gap(const Vec2& point_m, std::uint16_t robot) const;

  Team team_;
  FieldGeometry field_;
  RandomTargetsParams params_;
  Random random_;
  std::map<std::uint16_t, Assignment> assignments_;
  Targets targets_;
};

}  // namespace regista
