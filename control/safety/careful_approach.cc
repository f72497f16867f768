#include "control/safety/careful_approach.h"

#include <algorithm>
#include <cmath>

#include "world_model/types/crash_rule.h"

namespace regista {
namespace {

/// What an opponent's speed towards us may gain until it meets us, and what is the least that is expected of it: it may
/// turn to us yet.
constexpr double kGain_mps = 0.5;
constexpr double kLeastClosing_mps = 1.0;

/// Farther opponents hold nothing down: until they are near there is time to be careful.
constexpr double kFar_m = 3.0;

/// Less speed towards one opponent may be more towards another; so often all are looked at.
constexpr int kRounds = 3;

}  // namespace

double blameless_approach(double gap_m, double closing_mps, double braking_mps2) {
  // They meet after t = gap / (u + closing); u − braking·t is to be the blameless speed then.
  const double closing = std::max(kLeastClosing_mps, closing_mps + kGain_mps);
  const double less = closing - kBlamelessSpeed_mps;
  return (std::sqrt(less * less + 4.0 * (kBlamelessSpeed_mps * closing + braking_mps2 * gap_m)) - less) / 2.0;
}

Vec2 careful_approach(const Vec2& wanted_mps, const Vec2& from_m, std::span<const Opponent> opponents, double contact_m,
                      double braking_mps2) {
  Vec2 careful = wanted_mps;
  for (int round = 0; round < kRounds; ++round) {
    for (const Opponent& opponent : opponents) {
      const Vec2 apart = opponent.position_m - from_m;
      const double distance_m = apart.norm();
      if (!(distance_m > 0.0) || distance_m > kFar_m) continue;
      const Vec2 n = apart / distance_m;
      const double most =
          blameless_approach(std::max(0.0, distance_m - contact_m), -opponent.velocity_mps.dot(n), braking_mps2);
      const double towards = careful.dot(n);
      if (towards > most) careful -= (towards - most) * n;
    }
  }
  return careful;
}

}  // namespace regista
