// The whole loop without messages, for benches of motion: simulator, camera, world model, one driver per team, radio.
// The same setup gives the same bytes, and runs many times faster than the field.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "modules/bench/motion/driver.h"
#include "sim/simulator.h"
#include "sim/validators.h"
#include "world_model/world_model.h"

namespace regista::bench {

/// A team's targets for that estimated world; valid until the next call.
using TargetSource = std::function<const Targets&(const WorldState& world)>;

struct LoopTeam {
  std::unique_ptr<Driver> driver;  ///< nullptr: nobody commands these robots
  TargetSource targets;            ///< empty: none
};

struct LoopSetup {
  SimSetup sim;
  WorldModelParams model;  ///< what the system believes of delays, lag and noise
  std::array<LoopTeam, 2> teams;

  LoopTeam& of(Team team) { return teams[static_cast<std::size_t>(team)]; }
  const LoopTeam& of(Team team) const { return teams[static_cast<std::size_t>(team)]; }
};

/// What must hold whoever drives: bodies inside the boards, nobody told to be or being faster than it can.
struct LoopVerdict {
  std::size_t ticks = 0;  ///< looked at
  std::vector<Violation> violations;

  LoopVerdict& operator+=(const LoopVerdict& other);
};

class ClosedLoop {
 public:
  /// Throws as Simulator does.
  explicit ClosedLoop(LoopSetup setup);

  /// On to the next frame that arrives and tells something; both teams see it and command at once.
  void tick();
  /// As many ticks as begin within the time; `observe` is called after each.
  void run_for(double seconds, const std::function<void()>& observe = {});

  const Simulator& simulator() const { return simulator_; }
  /// For teleports between two ticks.
  Simulator& simulator() { return simulator_; }
  /// As estimated, predicted to when commands act.
  const WorldState& world() const { return world_; }
  /// How everything is.
  const WorldState& truth() const { return truth_; }
  /// What each team was told last, by Team.
  std::span<const TeamCommands> commands() const { return commands_; }
  const Driver* driver(Team team) const { return setup_.of(team).driver.get(); }
  const Targets& targets(Team team) const { return targets_[static_cast<std::size_t>(team)]; }
  LoopVerdict verdict() const { return {ticks_, validation_.violations()}; }
  /// Between the last two ticks.
  double dt_s() const { return dt_s_; }

 private:
  bool see();
  void drive(Team team);

  LoopSetup setup_;
  Simulator simulator_;
  WorldModel model_;
  WorldState world_;
  WorldState truth_;
  std::array<Targets, 2> targets_;
  std::array<TeamCommands, 2> commands_;
  std::optional<Time> last_captured_;
  double dt_s_ = 0.0;
  std::size_t ticks_ = 0;
  Validation validation_;
};

}  // namespace regista::bench
