#include "planning/game_rules.h"

#include <limits>

namespace regista {
namespace {

bool is_kick(SituationKind kind) {
  return kind == SituationKind::kick_off || kind == SituationKind::free_kick || kind == SituationKind::penalty;
}

}  // namespace

std::vector<Obstacle> rule_obstacles(Team team, const WorldState& world, const Situation& situation,
                                     const RuleParams& params, double robot_radius_m) {
  const double radius_m = params.ball_distance_m + params.ball_radius_m + robot_radius_m + params.margin_m;
  const bool is_ours = situation.team == team;
  const bool keeps_off = situation.kind == SituationKind::stop || (is_kick(situation.kind) && !is_ours);
  if (keeps_off && world.ball) return {disc(world.ball->position_m, radius_m)};
  if (situation.kind == SituationKind::ball_placement && !is_ours) {
    if (world.ball && situation.placement_m) {
      return {capsule(world.ball->position_m, *situation.placement_m, radius_m)};
    }
    if (situation.placement_m) return {disc(*situation.placement_m, radius_m)};
    if (world.ball) return {disc(world.ball->position_m, radius_m)};
  }
  return {};
}

double rule_speed_max(const Situation& situation, const RuleParams& params) {
  if (situation.kind == SituationKind::halt) return 0.0;
  if (situation.kind == SituationKind::stop) return params.stop_speed_mps;
  return std::numeric_limits<double>::infinity();
}

double rule_area_distance(const Situation& situation, const RuleParams& params) {
  const bool restricted = situation.kind == SituationKind::stop || situation.kind == SituationKind::free_kick;
  return restricted ? params.area_distance_m + params.margin_m : 0.0;
}

}  // namespace regista
