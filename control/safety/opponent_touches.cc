#include "control/safety/opponent_touches.h"

#include "control/safety/separation.h"

namespace regista {

void foresee_touches(std::span<const Opponent> opponents, double bodies_m, double until_s, std::vector<Touch>& out) {
  out.assign(opponents.size(), {});
  for (std::size_t i = 0; i < opponents.size(); ++i) {
    for (std::size_t j = i + 1; j < opponents.size(); ++j) {
      const Vec2 apart_m = opponents[j].position_m - opponents[i].position_m;
      const Vec2 velocity_mps = opponents[j].velocity_mps - opponents[i].velocity_mps;
      const double at_s = time_to_disc(apart_m, velocity_mps, bodies_m);
      if (at_s > until_s || (at_s >= out[i].at_s && at_s >= out[j].at_s)) continue;
      // Each goes on with the mean of what both bring along the line of centres.
      const Vec2 normal = (apart_m + at_s * velocity_mps).normalized();
      const Vec2 change_mps = 0.5 * velocity_mps.dot(normal) * normal;
      if (at_s < out[i].at_s) out[i] = {at_s, change_mps};
      if (at_s < out[j].at_s) out[j] = {at_s, -change_mps};
    }
  }
}

}  // namespace regista
