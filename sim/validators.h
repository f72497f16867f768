// Judges of a run, fed with the truth at every tick: what must hold always, and what must hold at the end.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "control/velocity_command.h"
#include "sim/contacts.h"
#include "sim/scenario.h"
#include "world_model/types/world_state.h"

namespace regista {

/// What a validator may look at; refers to the caller's values for the time of the call.
struct Observation {
  const WorldState& truth;
  const ContactCounts& contacts;
  std::int64_t reached_yellow = 0;  ///< targets so far
  std::int64_t reached_blue = 0;
  std::span<const TeamCommands> commands = {};  ///< what each team commanded last, before any limit of the simulator
};

struct Violation {
  std::string validator;
  Time at{};
  std::optional<RobotId> robot;  ///< where one is to blame
  double value = 0.0;
  double bound = 0.0;
  std::string unit;
  bool operator==(const Violation&) const = default;
};

/// One line: validator, time in seconds, robot, value, bound, unit.
std::string to_string(const Violation& violation);

struct Validator {
  enum class When { always, at_end };
  std::string name;
  When when = When::always;
  /// The violation seen in that observation; validator name and time are filled in by Validation.
  std::function<std::optional<Violation>(const Observation&)> check;
};

/// Every robot's disc stays inside the boards.
Validator inside_field(const FieldGeometry& field, double radius_m);
/// No robot drives or turns faster than it can. The simulator cuts commands to the limits, so this judges the
/// simulator; commands_within_limits judges who commands.
Validator within_speed_limits(const RobotLimits& limits);
/// No robot is told to drive or turn faster than it can. How fast commands change is not judged: they are in the body's
/// frame of a heading that only the controller knows, and may jump where a robot that was hit is picked up.
Validator commands_within_limits(const RobotLimits& limits);
/// The longest a body may be wholly inside a defence area it does not belong to: who is pushed in must be able to get
/// out, and driving across Division A's (1.8 m) at full speed takes less.
inline constexpr Duration kAreaStay{2'000'000};
/// No robot's body is wholly inside a defence area for longer than kAreaStay at a stretch. Robots that are inside when
/// first seen may stay until they leave. Remembers the robots of one run.
Validator defence_areas_kept(const FieldGeometry& field, double radius_m);
/// At the end the team has reached at least so many targets.
Validator targets_reached(Team team, std::int64_t count_min);
/// Contacts inside both teams together never exceed the number.
Validator own_contacts_at_most(std::int64_t count_max);
/// The same of contacts between the teams, whoever is at fault.
Validator opponent_contacts_at_most(std::int64_t count_max);

/// What a scenario asks for, with the limits the simulator was given.
std::vector<Validator> validators_of(const Scenario& scenario, const RobotLimits& limits);

/// Runs validators over a run and keeps the first violation of each.
class Validation {
 public:
  explicit Validation(std::vector<Validator> validators) : validators_(std::move(validators)) {}

  void observe(const Observation& observation);
  /// The last observation of the run: checks what must hold at the end too.
  void finish(const Observation& observation);

  /// In the order in which they were seen.
  const std::vector<Violation>& violations() const { return violations_; }

 private:
  void check(const Validator& validator, const Observation& observation);

  std::vector<Validator> validators_;
  std::vector<Violation> violations_;
};

}  // namespace regista
