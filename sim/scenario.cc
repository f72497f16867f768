#include "sim/scenario.h"

#include <stdexcept>

#include "sim/random_targets.h"
#include "sim/range_check.h"
#include "sim/sim_params.h"

namespace regista {

FieldGeometry field_of(const Scenario& scenario) {
  const FieldChoice& choice = scenario.field;
  FieldGeometry field;
  if (choice.division == "A") {
    field = division_a();
  } else if (choice.division == "B") {
    field = division_b();
  } else if (choice.division == "custom") {
    field.length_m = choice.length_m;
    field.width_m = choice.width_m;
  } else {
    throw std::invalid_argument("field.division is '" + choice.division + "', must be A, B or custom");
  }
  field.yellow_on_positive_x = choice.yellow_on_positive_x;
  return field;
}

void validate(const Scenario& scenario) {
  check_ranges(scenario);
  const FieldGeometry field = field_of(scenario);
  (void)sim_preset(scenario.sim_preset);
  if (scenario.field_source != "sim" && scenario.field_source != "ssl") {
    throw std::invalid_argument("field_source is '" + scenario.field_source + "', must be sim or ssl");
  }
  if (scenario.task != "random_targets" && scenario.task != "stand") {
    throw std::invalid_argument("task is '" + scenario.task + "', must be random_targets or stand");
  }
  if (!scenario.referee.empty() && !parse_command(scenario.referee)) {
    std::string known;
    for (const std::string& text : command_texts()) known += (known.empty() ? "" : ", ") + text;
    throw std::invalid_argument("referee is '" + scenario.referee + "', must be empty or one of: " + known);
  }
  // From anywhere, some place so far away must exist.
  if (scenario.task == "random_targets" && scenario.target_distance_min_m > field.length_m / 2.0) {
    throw std::invalid_argument("target_distance_min_m is " + std::to_string(scenario.target_distance_min_m) +
                                ", must be at most half the field's length, " + std::to_string(field.length_m / 2.0));
  }
  if (scenario.arrival_m >= scenario.target_distance_min_m) {
    throw std::invalid_argument("arrival_m is " + std::to_string(scenario.arrival_m) +
                                ", must be below target_distance_min_m, " +
                                std::to_string(scenario.target_distance_min_m));
  }
  if (scenario.task == "random_targets") {
    RandomTargetsParams params;
    params.distance_min_m = scenario.target_distance_min_m;
    require_far_places(field, params);
  }
  (void)formation(field, static_cast<int>(scenario.robots_per_team), RobotLimits{}.radius_m);
}

std::optional<GameState> stated_game(const Scenario& scenario) {
  validate(scenario);
  if (scenario.referee.empty()) return std::nullopt;
  const NamedCommand named = parse_command(scenario.referee).value();
  GameState game;
  game.command = named.command;
  game.team = named.team;
  game.command_counter = 1;
  if (named.command == GameCommand::ball_placement) game.placement_m = scenario.placement_m;
  return game;
}

std::vector<RobotPlacement> initial_placements(const Scenario& scenario) {
  validate(scenario);
  return formation(field_of(scenario), static_cast<int>(scenario.robots_per_team), RobotLimits{}.radius_m);
}

}  // namespace regista
