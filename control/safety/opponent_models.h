// What is expected of opponents, whose minds nobody knows, and whether a motion of ours keeps clear of it.
#pragma once

#include <span>
#include <vector>

#include "control/safety/motion.h"
#include "control/safety/opponent.h"
#include "control/safety/opponent_touches.h"
#include "control/safety/safety_params.h"
#include "world_model/types/robot_limits.h"

namespace regista {

/// How sure a motion is to be clear of where opponents are expected.
enum class Care {
  margins,    ///< with the margins
  steady_too  ///< and also of where they are if their velocities stay as they are; that margin does not grow
};

class OpponentModels {
 public:
  /// From now on the answers are about these. period_s > 0.
  void set(std::span<const Opponent> opponents, const RobotLimits& limits, const SafetyParams& params, double period_s);

  /// And about this robot of ours, which brakes so if it does not choose otherwise; must live while it is asked about.
  void set_robot(const Motion& braking);

  /// Of all opponents that brake from now on, for ever, by what such an opponent may still take with its next choice:
  /// as much as it can move the end of its braking within a period (opponent_reaction_s), but if it does as we do no
  /// more than half of what is left between both when both brake. So two that brake for each other both come on. (On a
  /// line that is exact; in the plane nearly, and the margin takes up the rest.)
  bool is_clear_of_braking(const Motion& ours) const;
  /// Of where each is expected (expected_motion.h) up to the horizon, with gaps that grow meanwhile, more for who
  /// drives and touches another one or is about to.
  bool is_clear_of_expected(const Motion& ours, Care care = Care::margins) const;
  /// How bad the worst crash is that is expected: 0 where nobody is expected within the margin before the crash
  /// horizon, 1 and more for what would be our foul by the crash rule, by m/s the more the clearer it is; any other is
  /// a lesser evil. Later is less certain and counts less.
  double crash_cost(const Motion& ours) const;

 private:
  struct Model {
    Motion braking;
    Motion expected;
    Motion steady;            ///< keeps its velocity
    double reaction_m = 0.0;  ///< by which the end of its braking can move within a period
    double growth_mps = 0.0;  ///< of the margin to where it is expected
  };

  /// What blocked the last motion mostly blocks the next one too, so it is asked first.
  template <class IsClear>
  bool all(IsClear&& is_clear) const {
    if (blocker_ < models_.size() && !is_clear(models_[blocker_])) return false;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (i == blocker_ || is_clear(models_[i])) continue;
      blocker_ = i;
      return false;
    }
    return true;
  }

  double room_for(const Model& model) const;

  std::vector<Model> models_;
  const Motion* our_braking_ = nullptr;
  mutable std::vector<double> rooms_m_;  ///< room_for each model as far as it was asked for, negative where not
  mutable std::size_t blocker_ = 0;      ///< changes no answer
  std::vector<Touch> touches_;           ///< scratch
  double gap_m_ = 0.0;                   ///< between centres, margin included
  double horizon_s_ = 0.0;
  double crash_horizon_s_ = 0.0;
};

}  // namespace regista
