#include "modules/bench/motion/dynamic_drive.h"

#include <algorithm>
#include <limits>

#include "modules/bench/motion/free_move.h"
#include "modules/bench/motion/scene_run.h"
#include "modules/bench/motion/shuttle.h"
#include "modules/bench/motion/simple_drivers.h"
#include "modules/bench/motion/target_sources.h"
#include "modules/bench/paper/dvg_scenario.h"

namespace regista::bench {
namespace {

constexpr double kCrossed_m = 0.09;      // as in paper/dvg_dynamic.cc
constexpr double kCollisionGap_s = 0.5;  // likewise
constexpr double kGiveUp_s = 60.0;
/// So that an obstacle keeps to its shuttle, whose acceleration is a robot's.
constexpr double kObstacleAcceleration_mps2 = 100.0;
constexpr double kCatchUp_s = 0.1;  // in which an obstacle is back where it should be
const RobotId kRobot{Team::yellow, 0};

/// 12 × 9 m without defence areas: the paper's robot starts and ends where they would be.
FieldGeometry open_field() {
  FieldGeometry field;
  field.defence_depth_m = 0.01;
  field.defence_width_m = 0.01;
  return field;
}

std::vector<Shuttle> shuttles_of(const DynamicScenario& scenario) {
  RobotLimits limits;
  limits.speed_max_mps = scenario.speed_mps;
  std::vector<Shuttle> shuttles;
  for (const Crossing& crossing : scenario.obstacles) shuttles.emplace_back(crossing.a, crossing.b, limits);
  return shuttles;
}

/// Obstacle i follows shuttle i.
std::unique_ptr<Driver> obstacles(std::vector<Shuttle> shuttles, std::span<const double> phases) {
  RobotLimits limits;
  limits.acceleration_max_mps2 = kObstacleAcceleration_mps2;
  limits.braking_max_mps2 = kObstacleAcceleration_mps2;
  const std::vector<double> kept(phases.begin(), phases.end());
  return std::make_unique<VelocityDriver>(
      Team::blue, limits,
      [shuttles = std::move(shuttles), kept](const RobotState& robot, const WorldState& world,
                                             const Target* /*target*/) -> Vec2 {
        constexpr double kAhead_s = 0.01;
        const Shuttle& shuttle = shuttles.at(robot.id.number);
        const double time_s = to_seconds(world.valid_at - Time{});
        const Vec2 due = shuttle.place(kept.at(robot.id.number), time_s);
        const Vec2 next = shuttle.place(kept.at(robot.id.number), time_s + kAhead_s);
        return (next - due) / kAhead_s + (due - robot.pose.position_m) / kCatchUp_s;
      });
}

RobotBody body_of(const RobotState& robot) { return {robot.id, robot.pose, robot.twist}; }

/// Counts as the paper does, and whose fault it was.
void count_collisions(const WorldState& truth, double time_s, double& last_s, DynamicDrive& out) {
  const RobotState& robot = *find_robot(truth, kRobot);
  for (const RobotState& other : truth.robots) {
    if (other.id == kRobot || time_s - last_s < kCollisionGap_s) continue;
    if ((other.pose.position_m - robot.pose.position_m).norm() >= 2.0 * RobotLimits{}.radius_m) continue;
    last_s = time_s;
    ++out.collisions;
    const Fault fault = crash_fault(body_of(robot), body_of(other));
    if (fault == Fault::first || fault == Fault::both) ++out.at_fault;
  }
}

bool is_crossed(std::span<const Vec2> path, const WorldState& world) {
  return !path.empty() && std::any_of(world.robots.begin(), world.robots.end(), [&](const RobotState& other) {
    return other.id != kRobot && distance_m(other.pose.position_m, path) < kCrossed_m;
  });
}

LoopSetup setup_of(const DynamicScenario& scenario, std::span<const double> phases, const Config& config,
                   std::uint64_t seed) {
  LoopSetup setup = loop_setup(config, seed);
  setup.sim.field = open_field();
  setup.sim.robots_collide = false;
  setup.sim.robots = {{kRobot, {scenario.start, 0.0}}};
  const std::vector<Shuttle> shuttles = shuttles_of(scenario);
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const Vec2 place = shuttles.at(i).place(phases[i], 0.0);
    setup.sim.robots.push_back({{Team::blue, static_cast<std::uint16_t>(i)}, {place, 0.0}});
  }
  // What the robot itself may do its controller knows.
  setup.sim.params.limits.acceleration_max_mps2 = kObstacleAcceleration_mps2;
  setup.sim.params.limits.braking_max_mps2 = kObstacleAcceleration_mps2;
  setup.of(Team::yellow).driver = std::make_unique<SystemDriver>(Team::yellow, system_params(config, Team::yellow));
  setup.of(Team::blue).driver = obstacles(shuttles, phases);
  return setup;
}

}  // namespace

DynamicDrive drive_dynamic(const DynamicScenario& scenario, std::span<const double> phases, const SystemChoice& system,
                           const std::string& preset, std::uint64_t seed) {
  Targets targets;
  targets.team = Team::yellow;
  targets.targets = {{.robot = kRobot.number, .pose = {scenario.goal, 0.0}, .speed_max_mps = scenario.speed_mps}};
  LoopSetup setup = setup_of(scenario, phases, loop_config(system, preset), seed);
  setup.of(Team::yellow).targets = source_of(targets);
  ClosedLoop loop(std::move(setup));
  DynamicDrive out;
  RobotLimits limits;
  limits.speed_max_mps = scenario.speed_mps;
  out.straight_s = straight_drive_s((scenario.goal - scenario.start).norm(), limits);
  double last_collision_s = -std::numeric_limits<double>::infinity();
  std::vector<Vec2> path;  // of the frame before
  for (double time_s = 0.0; !out.arrived && time_s < kGiveUp_s;) {
    loop.tick();
    time_s = to_seconds(loop.simulator().now() - Time{});
    count_collisions(loop.truth(), time_s, last_collision_s, out);
    if (is_crossed(path, loop.world())) ++out.crossed;
    const std::span<const RobotPlan> plans = loop.driver(Team::yellow)->plans();
    path = plans.empty() ? std::vector<Vec2>{} : plans.front().plan.path;
    const RobotState& robot = *find_robot(loop.truth(), kRobot);
    out.arrived =
        (robot.pose.position_m - scenario.goal).norm() <= kThere_m && robot.twist.velocity_mps.norm() <= kSlow_mps;
    out.navigation_s = time_s;
  }
  for (const DriveTime& time : loop.driver(Team::yellow)->times()) out.planning_ms += time.planning_us * 1e-3;
  out.verdict = loop.verdict();
  return out;
}

}  // namespace regista::bench
