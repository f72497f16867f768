// What a robot does from now on, in phases of constant acceleration: the values the safety search works with.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "world_model/types/geometry.h"
#include "world_model/types/robot_limits.h"

namespace regista {

/// Constant acceleration from begin_s until the next phase begins; the last one never ends.
struct Phase {
  double begin_s = 0.0;
  Vec2 position_m = Vec2::Zero();  ///< at its begin, as the velocity
  Vec2 velocity_mps = Vec2::Zero();
  Vec2 acceleration_mps2 = Vec2::Zero();
};

/// Where a phase has brought the robot elapsed_s after its begin.
inline Vec2 position_after(const Phase& phase, double elapsed_s) {
  return phase.position_m + elapsed_s * (phase.velocity_mps + (elapsed_s / 2.0) * phase.acceleration_mps2);
}
inline Vec2 velocity_after(const Phase& phase, double elapsed_s) {
  return phase.velocity_mps + elapsed_s * phase.acceleration_mps2;
}

class Motion {
 public:
  static constexpr std::size_t kPhasesMax = 4;

  Motion() = default;
  /// Drives on with that velocity, for ever until told otherwise.
  Motion(const Vec2& position_m, const Vec2& velocity_mps) : low_m_(position_m), high_m_(position_m) {
    phases_[0] = {0.0, position_m, velocity_mps, Vec2::Zero()};
  }

  /// The last phase gets this acceleration and ends after duration_s > 0; a new one at constant velocity follows. At
  /// most kPhasesMax − 1 times.
  void then(const Vec2& acceleration_mps2, double duration_s);
  /// The same, and at the end the robot stands, whatever rounding says.
  void then_stand(const Vec2& acceleration_mps2, double duration_s);

  /// Adds change_mps to the last phase's velocity, from its beginning on.
  void hit(const Vec2& change_mps) { phases_[count_ - 1].velocity_mps += change_mps; }

  /// The phase that lasts at_s >= 0 seconds from now.
  const Phase& phase_at(double at_s) const;

  std::span<const Phase> phases() const { return {phases_.data(), count_}; }
  /// When the last phase begins, seconds.
  double settled_s() const { return phases_[count_ - 1].begin_s; }
  /// The box that holds all phases but the last, corners in metres.
  const Vec2& low_m() const { return low_m_; }
  const Vec2& high_m() const { return high_m_; }

 private:
  std::array<Phase, kPhasesMax> phases_{};
  std::size_t count_ = 1;
  Vec2 low_m_ = Vec2::Zero();
  Vec2 high_m_ = Vec2::Zero();
};

/// Braking straight ahead to a stand, in whole control periods: k = ⌈|v| / (braking·period)⌉ of them with deceleration
/// |v| / (k·period). So after one period what is left is again this very motion, and a promise to brake stays one.
/// Before that it holds its velocity for hold_s >= 0.
Motion braking(const Vec2& position_m, const Vec2& velocity_mps, double hold_s, double braking_mps2, double period_s);

/// One period towards next_velocity_mps, hold_s at that velocity, then braking() from there.
Motion manoeuvre(const Vec2& position_m, const Vec2& velocity_mps, const Vec2& next_velocity_mps, double hold_s,
                 double braking_mps2, double period_s);

/// Keeps accelerating for hold_s, at least for period_s > 0, and then drives on, told for coast_s > 0. Where that would
/// exceed speed_max_mps, or the present speed if that is higher, it accelerates less, towards the velocity of that
/// speed in the same direction: at its top speed a robot can still turn.
Motion sustained(const Vec2& position_m, const Vec2& velocity_mps, const Vec2& acceleration_mps2, double hold_s,
                 double speed_max_mps, double period_s, double coast_s);

}  // namespace regista
