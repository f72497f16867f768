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
      geometry_(bus, channels::geometry()),
      referee_(bus, channels::referee()),
      plan_listener_(bus, channels::plans(team), [this](RobotPlan plan) { keep(std::move(plan)); }) {
  expose<ControllerModuleParams>(params_, [this](const ControllerModuleParams& changed) {
    controller_.set_params(changed.control);
    params_ = changed;
  });
}

void ControllerModule::keep(RobotPlan plan) {
  if (plan.robot.team != team_) return;
  const std::uint16_t robot = plan.robot.number;
  plans_[robot] = {std::move(plan), bus().now()};
}

bool ControllerModule::set_is_complete() const {
  if (world_.newest() == nullptr) return false;
  std::uint32_t of_this_world = 0;  // robots, not messages: one that comes twice makes no set complete
  std::uint32_t set_size = 1;
  for (const auto& [robot, kept] : plans_) {
    if (kept.plan.world_sequence != world_.newest()->sequence) continue;
    ++of_this_world;
    set_size = kept.plan.set_size;
  }
  return of_this_world >= set_size;
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
  if (world_.newest() == nullptr) return fresh;
  const Duration deadline = from_seconds(params_.control.plan_deadline_s);
  for (const auto& [robot, kept] : plans_) {
    // Both stamps are of the same vision: a planner that lags behind, or a replayed plan, is late by them even when its
    // message has just come in.
    const Duration behind = world_.newest()->captured - kept.plan.captured;
    if (now - kept.arrived <= deadline && behind <= deadline && behind >= -deadline) fresh.push_back(kept.plan);
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
  const Situation situation = situation_.update(referee_.newest(), world);
  Surroundings around;  // unknown until the field is
  if (const FieldAnnouncement* geometry = geometry_.newest()) {
    around = surroundings_of(team_, geometry->field, world, situation, params_.control.limits.radius_m);
  }
  publish(controller_.update(world, fresh_plans(now), dt_s, around));
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
