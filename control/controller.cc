#include "control/controller.h"

#include <algorithm>

#include "control/bang_bang.h"
#include "control/controller_input.h"
#include "control/heading_controller.h"
#include "control/motion_limits.h"
#include "control/path_follower.h"
#include "control/path_legs.h"
#include "control/present_motion.h"
#include "control/safety/careful_approach.h"
#include "planning/planner.h"

namespace regista {
namespace {

/// A plan that does not reach the goal still leads as near as is known, so it is driven too.
bool can_be_driven(const RobotPlan& plan) { return plan.plan.status != PlanStatus::invalid && !plan.plan.path.empty(); }

/// Where the robot gets to when the velocity it has runs out with its drive's lag. A drive follows its command as
/// v' = (u − v)/τ, so z = x + τ·v moves with z' = u: planned for z, the robot is one that obeys at once.
Pose after_lag(const RobotState& robot, double lag_s) {
  return {robot.pose.position_m + lag_s * robot.twist.velocity_mps,
          robot.pose.heading_rad + lag_s * robot.twist.angular_radps};
}

double length_of_path(std::span<const Vec2> path, const Vec2& from_m) {
  const std::size_t first = nearest_leg(path, from_m);
  return first + 1 < path.size() ? (path[first + 1] - from_m).norm() + length_of(path.subspan(first + 1)) : 0.0;
}

}  // namespace

Controller::Controller(Team team, const ControlParams& params)
    : team_(team), params_(params), wheels_(params.wheels, params.robot_wheels) {
  safety_mode(params.safety.mode);
}

void Controller::set_params(const ControlParams& params) {
  safety_mode(params.safety.mode);
  wheels_ = TeamWheels(params.wheels, params.robot_wheels);
  params_ = params;
}

/// Limits the wanted motion against the present one, which becomes what is commanded, and converts.
RobotCommand Controller::command(std::uint16_t robot, Told& motion, const Twist& wanted, double dt_s) const {
  Twist& twist = motion.twist;
  twist.velocity_mps = limited_velocity(twist.velocity_mps, wanted.velocity_mps, params_.limits, dt_s);
  twist.angular_radps = limited_rate(twist.angular_radps, wanted.angular_radps, params_.limits, dt_s);
  // The robot holds a velocity in its own frame and turns meanwhile: half the turn later is the period's mean.
  const double mean_heading_rad = motion.heading_rad + twist.angular_radps * dt_s / 2.0;
  RobotCommand out;
  out.robot = robot;
  out.velocity = to_body(twist, mean_heading_rad);
  const OmniWheels& wheels = wheels_.of(robot);
  out.wheel_speeds_radps = wheels.speeds(out.velocity);
  const double scale = wheels.scale_to_limit(out.wheel_speeds_radps);
  if (scale < 1.0) {
    twist = {scale * twist.velocity_mps, scale * twist.angular_radps};
    out.velocity = to_body(twist, mean_heading_rad);
    for (double& speed : out.wheel_speeds_radps) speed *= scale;
  }
  return out;
}

TeamCommands Controller::begin(const WorldState* world) {
  TeamCommands out;
  out.team = team_;
  out.sequence = ++sequence_;
  if (world != nullptr) {
    out.captured = world->captured;
    out.world_sequence = world->sequence;
  }
  return out;
}

/// What the plan asks the robot to do next; a robot without one that can be driven shall stand.
Controller::Intent Controller::intent_of(const RobotState& robot, const RobotPlan* plan, double dt_s) const {
  Intent intent;
  const auto last = last_.find(robot.id.number);
  intent.told = {present_motion(robot.twist, last == last_.end() ? nullptr : &last->second.twist, params_),
                 robot.pose.heading_rad};
  const Pose pose = after_lag(robot, params_.drive_lag_s);
  intent.robot = {pose.position_m, intent.told.twist.velocity_mps, Vec2::Zero(), params_.limits.speed_max_mps};
  intent.robot.must_stand = true;
  const bool seen = to_seconds(robot.age) <= params_.unseen_deadline_s;
  if (!seen || plan == nullptr || !can_be_driven(*plan)) return intent;
  RobotLimits limits = params_.limits;
  limits.speed_max_mps = std::clamp(plan->target.speed_max_mps, 0.0, limits.speed_max_mps);
  const Vec2& velocity = intent.told.twist.velocity_mps;
  intent.robot.must_stand = limits.speed_max_mps == 0.0;
  intent.robot.speed_max_mps = limits.speed_max_mps;
  intent.robot.may_enter_own_area = plan->target.may_enter_own_area;
  intent.robot.wanted_mps = follow_path(plan->plan.path, pose.position_m, velocity, limits, params_.follower, dt_s);
  intent.rate_radps = wanted_rate(pose.heading_rad, intent.told.twist.angular_radps, plan->target.pose.heading_rad,
                                  limits, params_.heading, dt_s);
  if (limits.speed_max_mps > 0.0) {
    intent.arrival_s =
        bang_bang_duration(length_of_path(plan->plan.path, pose.position_m), velocity.norm(),
                           {limits.acceleration_max_mps2, limits.braking_max_mps2, limits.speed_max_mps});
  }
  return intent;
}

void Controller::be_careful(std::span<SafetyRobot> robots, std::span<const Opponent> opponents) const {
  if (safety_mode(params_.safety.mode) != SafetyMode::team) return;
  const double contact_m = 2.0 * params_.limits.radius_m + params_.safety.opponent_margin_m;
  // Some of what the wheels can do goes into dodging meanwhile.
  const double braking_mps2 = params_.safety.braking_share * params_.limits.acceleration_max_mps2;
  for (SafetyRobot& robot : robots) {
    robot.wanted_mps = careful_approach(robot.wanted_mps, robot.position_m, opponents, contact_m, braking_mps2);
  }
}

TeamCommands Controller::update(const WorldState& world, std::span<const RobotPlan> plans, double dt_s,
                                const Surroundings& around) {
  const double period_s = checked_period_s(dt_s, params_.period_max_s);
  const auto plan_of = plans_of(team_, plans);
  require_finite(world);

  std::vector<std::uint16_t> numbers;
  std::vector<Intent> intents;
  std::vector<SafetyRobot> robots;
  std::vector<double> arrivals_s;
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team_) continue;
    const auto plan = plan_of.find(robot.id.number);
    intents.push_back(intent_of(robot, plan != plan_of.end() ? plan->second : nullptr, period_s));
    numbers.push_back(robot.id.number);
    robots.push_back(intents.back().robot);
    arrivals_s.push_back(intents.back().arrival_s);
  }
  const std::span<const Opponent> opponents = opponents_.update(world, opponent_of(team_), params_, period_s);
  rough_play_.update(world, team_, period_s, params_.limits.radius_m, params_.rough_play);
  if (rough_play_.is_rough(params_.rough_play)) be_careful(robots, opponents);
  const std::vector<Vec2>& chosen_mps =
      avoidance_.choose(robots, arrivals_s, opponents, around, params_,
                        {.period_s = period_s, .delay_s = planning_delay_s(world, params_.drive_lag_s)});

  TeamCommands out = begin(&world);
  last_.clear();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Told& told = intents[i].told;
    out.commands.push_back(command(numbers[i], told, {chosen_mps[i], intents[i].rate_radps}, period_s));
    last_.emplace_hint(last_.end(), numbers[i], told);
  }
  return out;
}

TeamCommands Controller::brake(const WorldState* last_world, double dt_s) {
  const double period_s = checked_period_s(dt_s, params_.period_max_s);
  TeamCommands out = begin(last_world);
  for (auto& [robot, motion] : last_) {
    // Nobody sees the robot: it has turned as it was told.
    motion.heading_rad = wrap_angle(motion.heading_rad + motion.twist.angular_radps * period_s);
    out.commands.push_back(command(robot, motion, Twist{}, period_s));
  }
  return out;
}

}  // namespace regista
