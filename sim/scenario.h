// A scenario as a value: field, robots, what they shall do, what shall hold at the end. Files are read by modules/.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/formation.h"
#include "world_model/params.h"
#include "world_model/types/game_state.h"

namespace regista {

struct FieldChoice {
  std::string division = "A";  ///< "A", "B", or "custom": division A with the lengths below
  double length_m = 12.0;      ///< custom only
  double width_m = 9.0;        ///< custom only
  bool yellow_on_positive_x = false;
  bool operator==(const FieldChoice&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("division", self.division, Range{}, "", "A, B, or custom: A with length_m and width_m");
    v("length_m", self.length_m, Range{4, 1000}, "m", "goal line to goal line, custom only");
    v("width_m", self.width_m, Range{3, 1000}, "m", "touch line to touch line, custom only");
    v("yellow_on_positive_x", self.yellow_on_positive_x, Range{}, "", "yellow defends the goal at +x");
  }
};

/// What must hold at the end of a run. -1: not checked.
struct Expectations {
  std::int64_t targets_per_team_min = 0;
  std::int64_t own_contacts_max = -1;  ///< of both teams together
  std::int64_t opponent_contacts_max = -1;
  bool operator==(const Expectations&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("targets_per_team_min", self.targets_per_team_min, Range{0, 1e9}, "", "targets each team must reach");
    v("own_contacts_max", self.own_contacts_max, Range{-1, 1e9}, "", "contacts inside teams, -1: any number");
    v("opponent_contacts_max", self.opponent_contacts_max, Range{-1, 1e9}, "",
      "contacts between the teams, -1: any number");
  }
};

struct Scenario {
  std::string name = "crossing";
  FieldChoice field;
  std::string field_source = "sim";  ///< or "ssl": a field or simulator that speaks the league's protocols
  std::int64_t robots_per_team = 11;
  std::int64_t seed = 1;
  double duration_s = 60.0;
  std::string sim_preset = "noisy";
  std::string task = "random_targets";  ///< or "stand"
  std::string referee;                  ///< what the referee says all the time, "stop"; empty: nothing
  Vec2 placement_m = Vec2::Zero();      ///< where the ball is to be placed, when the referee says so
  double target_distance_min_m = 3.0;   ///< a new target is at least so far from the robot
  double arrival_m = 0.05;              ///< arrived when so near to the target
  Expectations expect;
  bool operator==(const Scenario&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("name", self.name, Range{}, "", "how tables and files call it");
    v.group("field", self.field);
    v("field_source", self.field_source, Range{}, "", "sim, or ssl: a field that speaks the league's protocols");
    v("robots_per_team", self.robots_per_team, Range{1, 1000}, "", "number 0 is the goalkeeper");
    v("seed", self.seed, Range{0, 9e15}, "", "of everything random");
    v("duration_s", self.duration_s, Range{0.01, 1e6}, "s", "simulated");
    v("sim_preset", self.sim_preset, Range{}, "", "none, noisy, realistic");
    v("task", self.task, Range{}, "", "random_targets or stand");
    v("referee", self.referee, Range{}, "", "command to play under: stop, halt, ball_placement_yellow, …; empty: none");
    v("placement_x_m", self.placement_m.x(), Range{-1000, 1000}, "m", "where the ball is to be placed");
    v("placement_y_m", self.placement_m.y(), Range{-1000, 1000}, "m", "where the ball is to be placed");
    v("target_distance_min_m", self.target_distance_min_m, Range{0.2, 1000}, "m", "from the robot to its new target");
    v("arrival_m", self.arrival_m, Range{0.001, 1}, "m", "arrived when so near to the target");
    v.group("expect", self.expect);
  }
};

/// The field it is played on. Throws std::invalid_argument for an unknown division.
FieldGeometry field_of(const Scenario& scenario);

/// What the referee says all the time; nothing where the scenario has none. Throws as validate.
std::optional<GameState> stated_game(const Scenario& scenario);

/// Throws std::invalid_argument with one line that says which entry is wrong and what would be right.
void validate(const Scenario& scenario);

/// Robots of both teams in formation; throws as validate and formation do.
std::vector<RobotPlacement> initial_placements(const Scenario& scenario);

}  // namespace regista
