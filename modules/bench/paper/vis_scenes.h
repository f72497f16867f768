// The scenes of "A Mapping & Planning Algorithm for RoboCup Small Size League" (2022): a robot behind a wall of robots,
// and twelve agents playing. Margins, defence areas and goals are those of a live team (planning/obstacle_rules.h).
#pragma once

#include "modules/bench/paper/sampling_data.h"

namespace regista::bench {

inline constexpr const char* kVisFile = "vis_tables.toml";

/// From [wall]: the robot that asks is of the yellow team, those in its way are blue.
Scene wall_scene(const DataTable& wall);

/// Two teams of that many on 9 × 6 m (division B), anywhere but in each other, keepers alone in their defence areas; a
/// random yellow robot that is no keeper asks for the way to a random place.
Scene agents_scene(std::size_t robots_per_team, std::mt19937_64& random);

}  // namespace regista::bench
