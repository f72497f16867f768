// A team's wanted velocities into those it gets: first kept out of the way of moving neighbours, then made safe, as the
// mode of SafetyParams says.
#pragma once

#include <span>
#include <vector>

#include "control/control_params.h"
#include "control/safety/opponent.h"
#include "control/safety/safety_search.h"
#include "control/velocity_choice.h"

namespace regista {

/// "none", "published", "team". Throws std::invalid_argument, naming them, for any other.
enum class SafetyMode { none, published, team };
SafetyMode safety_mode(const std::string& name);

/// Of a tick, seconds.
struct TickTimes {
  double period_s = 0.0;  ///< > 0, until the next one
  double delay_s = 0.0;   ///< >= 0, planning_delay_s: how old what is known of opponents is by then
};

class Avoidance {
 public:
  /// Velocities a period later, one per robot; those of mode none are the wanted ones and need not be reachable.
  /// `arrivals_s`: when each robot would stand at its goal. Valid until the next call.
  const std::vector<Vec2>& choose(std::span<SafetyRobot> team, std::span<const double> arrivals_s,
                                  std::span<const Opponent> opponents, const Surroundings& around,
                                  const ControlParams& params, const TickTimes& times);

 private:
  void keep_out_of_the_way(std::span<SafetyRobot> team, std::span<const double> arrivals_s,
                           std::span<const Opponent> opponents, const ControlParams& params, double delay_s);

  SafetySearch search_;
  std::vector<Neighbour> neighbours_;
  std::vector<Vec2> chosen_;
};

}  // namespace regista
