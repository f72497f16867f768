#include "modules/bench/motion/closed_loop.h"

#include <utility>

namespace regista::bench {
namespace {

constexpr std::array kTeams{Team::yellow, Team::blue};

std::vector<Validator> validators_of(const SimSetup& sim) {
  const RobotLimits& limits = sim.params.limits;
  return {inside_field(sim.field, limits.radius_m), within_speed_limits(limits), commands_within_limits(limits)};
}

}  // namespace

LoopVerdict& LoopVerdict::operator+=(const LoopVerdict& other) {
  ticks += other.ticks;
  violations.insert(violations.end(), other.violations.begin(), other.violations.end());
  return *this;
}

ClosedLoop::ClosedLoop(LoopSetup setup)
    : setup_(std::move(setup)),
      simulator_(setup_.sim),
      model_(setup_.model),
      truth_(simulator_.truth()),
      validation_(validators_of(setup_.sim)) {
  for (const Team team : kTeams) targets_.at(static_cast<std::size_t>(team)).team = team;
}

void ClosedLoop::tick() {
  while (!see()) {
  }
  world_ = model_.state();
  truth_ = simulator_.truth();
  dt_s_ = last_captured_ ? to_seconds(world_.captured - *last_captured_) : 0.0;
  if (dt_s_ <= 0.0) dt_s_ = 1.0 / setup_.sim.params.vision.rate_hz;
  last_captured_ = world_.captured;
  for (const Team team : kTeams) drive(team);
  ++ticks_;
  validation_.observe({truth_, simulator_.contact_counts(), 0, 0, commands_});
}

/// On to the next frame. False where the world model had no use for it.
bool ClosedLoop::see() {
  simulator_.advance_to(simulator_.next_frame_due());
  bool changed = false;
  for (const VisionFrame& frame : simulator_.take_frames()) {
    const FrameResult result = model_.add_frame(frame);
    changed = changed || result == FrameResult::taken || result == FrameResult::restarted;
  }
  return changed;
}

void ClosedLoop::drive(Team team) {
  LoopTeam& side = setup_.of(team);
  if (side.driver == nullptr) return;
  Targets& targets = targets_.at(static_cast<std::size_t>(team));
  if (side.targets) targets = side.targets(world_);
  TeamCommands& commands = commands_.at(static_cast<std::size_t>(team));
  commands = side.driver->drive(setup_.sim.field, world_, targets, dt_s_);
  simulator_.command(commands, simulator_.now());
  for (const RobotCommand& command : commands.commands) {
    model_.add_command({team, command.robot}, {commands.captured, command.velocity});
  }
}

void ClosedLoop::run_for(double seconds, const std::function<void()>& observe) {
  const Time end = simulator_.now() + from_seconds(seconds);
  while (simulator_.next_frame_due() < end) {
    tick();
    if (observe) observe();
  }
}

}  // namespace regista::bench
