#include "modules/bench/motion/free_move.h"

#include "sim/robot_model.h"

namespace regista::bench {
namespace {

constexpr double kPeriod_s = 0.01;
constexpr int kStepsPerPeriod = 10;
constexpr double kNoLimit_mps = 20.0;  // what parameters allow at most

/// Nothing but grass.
FieldGeometry empty_field() {
  FieldGeometry field;
  field.length_m = 200.0;
  field.width_m = 200.0;
  return field;
}

}  // namespace

SystemParams free_params(const SystemChoice& choice, double acceleration_mps2, double braking_mps2) {
  SystemParams params = system_params(loop_config(choice, "none"), Team::yellow);
  params.control.limits.speed_max_mps = kNoLimit_mps;
  params.control.limits.acceleration_max_mps2 = acceleration_mps2;
  params.control.limits.braking_max_mps2 = braking_mps2;
  params.control.wheels.wheel_speed_max_radps = 2000.0;
  return params;
}

FreeMove drive_freely(const FreeState& from, const SystemParams& params) {
  const FieldGeometry field = empty_field();
  SystemDriver driver(Team::yellow, params);
  Targets targets;
  targets.team = Team::yellow;
  targets.targets = {{.robot = 0, .pose = {}, .speed_max_mps = kNoLimit_mps}};
  RobotBody body{{Team::yellow, 0}, {from.position_m, 0.0}, {from.velocity_mps, 0.0}};
  WorldState world;
  for (int tick = 0; tick * kPeriod_s < kFreeLimit_s; ++tick) {
    if (body.pose.position_m.norm() <= kThere_m && body.twist.velocity_mps.norm() <= kSlow_mps) {
      return {tick * kPeriod_s, {body.pose.position_m, body.twist.velocity_mps}};
    }
    world.captured = Time{} + from_seconds(tick * kPeriod_s);
    world.valid_at = world.captured;
    ++world.sequence;
    world.robots = {{.id = body.id, .pose = body.pose, .twist = body.twist}};
    const TeamCommands commands = driver.drive(field, world, targets, kPeriod_s);
    for (int i = 0; i < kStepsPerPeriod; ++i) {
      step(body, commands.commands.at(0).velocity, params.control.limits, 0.0, kPeriod_s / kStepsPerPeriod);
    }
  }
  return {std::nullopt, {body.pose.position_m, body.twist.velocity_mps}};
}

}  // namespace regista::bench
