#include "control/safety/surroundings.h"

#include "planning/obstacle_rules.h"

namespace regista {

Surroundings surroundings_of(Team team, const FieldGeometry& field, const WorldState& world, const Situation& situation,
                             double robot_radius_m) {
  PlanningParams bare;
  bare.robot_radius_m = robot_radius_m;
  bare.area_margin_m = 0.0;
  bare.wall_margin_m = 0.0;
  bare.rules.margin_m = 0.03;  // by so much a robot that was pushed or seen wrongly comes nearer than it was meant to
  return {half_extent(field, robot_radius_m), static_obstacles(team, field, world, situation, bare), kOwnArea};
}

}  // namespace regista
