#include "modules/world_model/world_model_module.h"

namespace regista {
namespace {

constexpr std::size_t kWaiting = 256;  // a second of frames, or of commands, at the highest rates in use

}  // namespace

WorldModelModule::WorldModelModule(Bus& bus, const WorldModelParams& params, Stopwatch stopwatch)
    : Module("world-model", bus),
      params_(params),
      model_(params),
      stopwatch_(std::move(stopwatch)),
      frames_(bus, channels::vision(), kWaiting),
      yellow_commands_(bus, channels::commands(Team::yellow), kWaiting),
      blue_commands_(bus, channels::commands(Team::blue), kWaiting) {
  expose<WorldModelParams>(params_, [this](const WorldModelParams& changed) {
    model_.set_params(changed);
    params_ = changed;
  });
}

std::string WorldModelModule::note() const {
  if (!seen_) return "waiting for VISION";
  // One frame in a hundred is a hiccup; more is a camera whose clock or load is wrong, and somebody must know.
  constexpr std::int64_t kBearable = 100;
  const FrameCounts& frames = model_.frame_counts();
  if ((frames.late + frames.refused) * kBearable <= frames.taken) return {};
  return "of " + std::to_string(frames.taken) + " frames taken, " + std::to_string(frames.late) +
         " came too late and " + std::to_string(frames.refused) + " had impossible times";
}

void WorldModelModule::take_commands(Queue<TeamCommands>& queue) {
  while (const auto commands = queue.pop()) {
    for (const RobotCommand& command : commands->commands) {
      model_.add_command({commands->team, command.robot}, {commands->captured, command.velocity});
    }
  }
}

void WorldModelModule::on_tick(Time) {
  const std::int64_t begin_ns = stopwatch_();
  take_commands(yellow_commands_);
  take_commands(blue_commands_);
  bool changed = false;
  while (const auto frame = frames_.pop()) {
    const FrameResult result = model_.add_frame(*frame);
    changed = changed || result == FrameResult::taken || result == FrameResult::restarted;
  }
  if (!changed) return;
  seen_ = true;
  const WorldState state = model_.state();
  bus().publish(channels::world_state(), state);
  bus().publish(channels::timing(name()), Timing{state.captured, name(), stopwatch_() - begin_ns, {}});
}

}  // namespace regista
