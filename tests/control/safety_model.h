// The safety search written once more, plainly, with a switch for each thing its proof needs: without it, teams touch.
#pragma once

#include "tests/support/safe_teams.h"

namespace regista::testing {

enum class Flaw {
  none,
  partial_periods,          ///< braking at the full limit ends within a period instead of with one
  simultaneous,             ///< everybody is checked against what the others promised before this period
  sampled,                  ///< distances are checked at the ends of periods, not between
  least_bad,                ///< where no sample is safe, the one that comes least near instead of braking
  ignores_margin_breakers,  ///< who is nearer than the margin already is not checked
  insists_on_margin,        ///< who is nearer than the margin already is unsafe whatever it does
  own_reach_only,           ///< mates farther than the own braking distance are not checked
};

/// What SafetySearch chooses without opponents and with hold_s = 0.
std::vector<Vec2> model_choice(const SafeTeam& team, Flaw flaw);

}  // namespace regista::testing
