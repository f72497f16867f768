// Judges of the rules of the game that bind motion (SSL rules: "Stop", "Ball placement", "Free kick"). Written from the
// rules alone, not from what planning makes of them.
#pragma once

#include "sim/validators.h"

namespace regista {

/// Teams have this long to comply: the rules give it for the speed in stop, and count more than 2 s on the line of a
/// placement as a foul.
inline constexpr Duration kRuleGrace{2'000'000};

/// at_first: from the grace after the first look on, never. each_stay: never longer than the grace at a stretch, as the
/// rules count where the ball may roll towards a robot.
enum class Grace : std::uint8_t { at_first, each_stay };

/// After the first grace no robot drives faster than 1.5 m/s.
Validator stop_speed_kept();

/// After the first grace every robot stands still.
Validator halt_kept();

/// The bodies of all robots, but for the exempt team's, are at least 0.5 m from the ball's surface.
Validator ball_distance_kept(std::optional<Team> exempt, double robot_radius_m, Grace grace);

/// All bodies, but for the placing team's, are at least 0.5 m from the line between the ball's centre and the place.
Validator placement_kept(std::optional<Team> placing, const Vec2& place_m, double robot_radius_m, Grace grace);

/// All bodies are at least 0.2 m from the defence area of the other team.
Validator area_distance_kept(const FieldGeometry& field, double robot_radius_m, Grace grace);

/// What the scenario's referee demands all the time; nothing without one.
std::vector<Validator> rule_validators(const Scenario& scenario, const RobotLimits& limits);

}  // namespace regista
