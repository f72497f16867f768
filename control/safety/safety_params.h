// What can be set of the ways to avoid contact: the safety search and the velocity choice before it.
#pragma once

#include <string>

#include "world_model/params.h"

namespace regista {

struct SafetyParams {
  std::string mode = "team";  ///< "none", "published" (as the visibility-sampling paper tells it) or "team"
  /// Between bodies of the team. Noise of vision and delays eat it: with preset noisy no contact that no opponent
  /// pushed for was seen at 20 mm (README, bench crowd); `regista bench margins` shows what errors of the model ask
  /// for.
  double team_margin_m = 0.02;
  /// Of the braking limit, what promises to brake count on, and what opponents are taken to brake with. A robot that
  /// turns while it brakes needs the rest to keep its direction: with all of it promised, some ran into walls, and
  /// mates into them.
  double braking_share = 0.9;
  double opponent_margin_m = 0.02;  ///< likewise; what they may do is in the margins below
  /// How far one control period can move the end of an opponent's braking, per speed: period + period·acceleration /
  /// braking = 17.5 ms at 100 Hz, rounded up: so who is clear of opponents' braking still is a period later. Where less
  /// than twice that is left, half of the rest is enough among those that do likewise; that gains 1 % of the pace.
  double opponent_reaction_s = 0.018;
  double acceleration_lasts_s = 0.3;  ///< from when commands act on, or until it stands: opponents'
  /// The same of one that speeds up straight ahead, where its team's top speed is known, and at most to that. Obstacles
  /// that turn round in the robot's way are met less often than where it is 0.3 s at any speed (`bench dynamic`).
  double speeding_up_lasts_s = 0.6;
  /// What is expected of an opponent errs the more, the later and the faster it moves: the margin grows by this share
  /// of the way it drives meanwhile, and by more while opponents jostle each other (opponent_models.cc). So what is
  /// planned for later still holds when later comes.
  double opponent_growth = 0.06;
  double horizon_s = 1.0;  ///< opponents are predicted so far; farther, they have changed their minds
  /// A change of velocity counts as an evasion when keeping it up for one of these times and driving on then is clear
  /// of where opponents are expected: a period alone changes nothing, and who only ever brakes comes to stand in the
  /// line of fire.
  double evasion_short_s = 0.15;
  double evasion_long_s = 0.6;
  /// Who cannot keep clear of where opponents are expected takes the velocity with the lightest crash before this time;
  /// 0: none is looked for, and it keeps clear of opponents that brake, or else brakes itself. Among opponents that
  /// avoid nobody this takes away half of the contacts and most of the fouls that braking leaves.
  double crash_horizon_s = 1.0;
  /// Directions of sampled accelerations; each with three magnitudes. About two samples are tested per robot, more have
  /// bought nothing.
  std::int64_t directions = 16;
  /// Team-mates are also expected to hold their velocities for so long before they brake, and kept clear of where that
  /// is possible. The longer, the earlier conflicts show, while they are cheap to avoid, and the more room is kept for
  /// nothing.
  double hold_s = 0.16;
  bool operator==(const SafetyParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("mode", self.mode, Range{}, "", "none, published or team");
    v("team_margin_m", self.team_margin_m, Range{0.0, 1.0}, "m", "kept between team-mates");
    v("braking_share", self.braking_share, Range{0.1, 1.0}, "", "share of the braking limit that is counted on");
    v("opponent_margin_m", self.opponent_margin_m, Range{0.0, 1.0}, "m", "kept to opponents");
    v("opponent_reaction_s", self.opponent_reaction_s, Range{0.0, 1.0}, "s", "further margin per opponent's speed");
    v("acceleration_lasts_s", self.acceleration_lasts_s, Range{0.0, 2.0}, "s", "an opponent's acceleration lasts");
    v("speeding_up_lasts_s", self.speeding_up_lasts_s, Range{0.0, 2.0}, "s",
      "straight ahead for so long, to its team's top speed at most, where that is known");
    v("opponent_growth", self.opponent_growth, Range{0.0, 1.0}, "",
      "by this share of an opponent's way its margin grows");
    v("horizon_s", self.horizon_s, Range{0.01, 10.0}, "s", "opponents are predicted so far");
    v("evasion_short_s", self.evasion_short_s, Range{0.0, 2.0}, "s", "an evasion accelerates for so long");
    v("evasion_long_s", self.evasion_long_s, Range{0.0, 2.0}, "s", "or for so long");
    v("crash_horizon_s", self.crash_horizon_s, Range{0.0, 10.0}, "s",
      "who cannot keep clear takes the lightest of the crashes expected within so long; 0: any");
    v("directions", self.directions, Range{1.0, 360.0}, "", "of sampled accelerations, three magnitudes each");
    v("hold_s", self.hold_s, Range{0.0, 2.0}, "s",
      "where possible, team-mates are kept clear of for so long before braking");
  }
};

}  // namespace regista
