// Where two of a team are in each other's only way, as head-on in a corridor, one of them leaves the other's way until
// that has passed.
#pragma once

#include <span>

#include "planning/out_of_the_way.h"

namespace regista {

/// A robot gives way when it is proved to have no way (unreachable), has one if no team-mate stood anywhere, and on
/// that meets a team-mate that is still under way and closes it alone. Of two that meet each other so, it is the one
/// with the shorter way out, which gets shorter as it goes. Outside of the other's way it stays outside: its plan goes
/// on as far as that allows. In the other's way its plan leads to the nearest place that is not, at most within_m from
/// here (0: nobody gives way). The status stays, the reason says so. `mates` are the sorted indices of the team's
/// obstacles. The answer depends on the arguments alone.
void give_way(const ObstacleField& field, std::span<const std::size_t> mates, double within_m,
              std::span<const Traveller> travellers);

}  // namespace regista
