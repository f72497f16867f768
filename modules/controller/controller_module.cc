#include "modules/controller/controller_module.h"

#include <algorithm>

namespace regista {
namespace {

constexpr Duration kBrakeEvery = std::chrono::milliseconds(10);  // the rate commands have while all is well

bool moves(const TeamCommands& commands) {
  return std::any_of(commands.commands.begin(), commands.commands.end(),
                     [](const RobotCommand& command) { return !(command.velocity == BodyVelocity{}); });
}

}  // namespace

ControllerModule::ControllerModule(Bus& bus, Team team, const ControllerModuleParams& params, Stopwatch stopwatch)
    : Module(channels::of("controller", team), bus),
      team_(team),
      params_(params),
      controller_(team, params.control),
      stopwatch_(std::move(stopwatch)),
      world_(bus, channels::world_state()),
      plan_listener_(bus, channels::plans(team), [this](RobotPlan plan) { keep(std::move(plan)); }) {
  expose<ControllerModuleParams>(params_, [this](const ControllerModuleParams& changed) {
    controller_.set_params(changed.control);
    params_ = changed;
  });
}

void ControllerModule::keep(RobotPlan plan) {
  if (plan.robot.team != team_) return;
  if (plan.world_sequence != set_sequence_) {
    set_sequence_ = plan.world_sequence;
    set_received_ = 0;
  }
  ++set_received_;
  set_size_ = plan.set_size;
  const std::uint16_t robot = plan.robot.number;
  plans_[robot] = {std::move(plan), bus().now()};
}

bool ControllerModule::set_is_complete() const {
  return world_.newest() != nullptr && set_received_ >= set_size_ && set_received_ > 0 &&
         set_sequence_ == world_.newest()->sequence;
}

Time ControllerModule::plans_due() const { return world_.arrived() + from_seconds(params_.plan_wait_s); }

Time ControllerModule::brake_due() const {
  const Time quiet = world_.arrived() + from_seconds(params_.control.world_deadline_s);
  return braked_at_ ? std::max(quiet, *braked_at_ + kBrakeEvery) : quiet;
}

std::optional<Time> ControllerModule::due() const {
  if (world_.newest() == nullptr) return std::nullopt;
  if (world_.fresh()) return plans_due();
  if (standing_) return std::nullopt;
  return brake_due();
}

std::string ControllerModule::note() const {
  if (world_.newest() == nullptr) return "waiting for WORLD_STATE";
  if (!world_.is_younger_than(from_seconds(params_.control.world_deadline_s))) return "braking: no WORLD_STATE";
  if (fresh_plans(bus().now()).empty()) return "braking: no plans";
  return {};
}

void ControllerModule::on_tick(Time now) {
  if (world_.fresh()) {
    if (set_is_complete() || now >= plans_due()) command(now);
  } else if (!standing_ && now >= brake_due()) {
    brake(now);
  }
}

std::vector<RobotPlan> ControllerModule::fresh_plans(Time now) const {
  std::vector<RobotPlan> fresh;
  for (const auto& [robot, kept] : plans_) {
    if (now - kept.arrived <= from_seconds(params_.control.plan_deadline_s)) fresh.push_back(kept.plan);
  }
  return fresh;
}

void ControllerModule::command(Time now) {
  const std::int64_t begin_ns = stopwatch_();
  const WorldState& world = *world_.take();
  double dt_s = last_captured_ ? to_seconds(world.captured - *last_captured_) : params_.control.period_s;
  if (dt_s <= 0.0) dt_s = params_.control.period_s;  // the source of vision has begun anew
  last_captured_ = world.captured;
  braked_at_.reset();
  publish(controller_.update(world, fresh_plans(now), dt_s));
  bus().publish(channels::timing(name()), Timing{world.captured, name(), stopwatch_() - begin_ns, {}});
}

void ControllerModule::brake(Time now) {
  braked_at_ = now;
  publish(controller_.brake(world_.newest(), to_seconds(kBrakeEvery)));
}

void ControllerModule::publish(const TeamCommands& commands) {
  standing_ = !moves(commands);
  bus().publish(channels::commands(team_), commands);
}

}  // namespace regista
