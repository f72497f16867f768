#include "modules/bench/motion/scene_run.h"

#include <algorithm>
#include <cmath>

#include "control/speed_profile.h"
#include "modules/bench/motion/simple_drivers.h"
#include "modules/bench/motion/target_sources.h"

namespace regista::bench {
namespace {

constexpr std::array kTeams{Team::yellow, Team::blue};
constexpr double kChaseSpeed_mps = 3.0;

/// A robot's way, watched.
class Watch {
 public:
  Watch(RobotId robot, const Vec2& from, const Vec2& target, const RobotLimits& limits) : target_(target) {
    arrival_.robot = robot;
    arrival_.straight_s = straight_drive_s((target - from).norm(), limits);
  }

  void look(const RobotState& robot, double time_s, double dt_s) {
    const double distance_m = (robot.pose.position_m - target_).norm();
    if (!arrival_.arrived_s && distance_m <= kArrival_m) arrival_.arrived_s = time_s;
    distances_.push_back(distance_m);
    squares_.push_back(robot.twist.velocity_mps.squaredNorm());
    dt_s_ = dt_s;
  }
  RobotId robot() const { return arrival_.robot; }
  bool arrived() const { return arrival_.arrived_s.has_value(); }

  Arrival result() const {
    Arrival out = arrival_;
    if (arrived() || distances_.empty()) return out;
    const auto ticks = std::min(distances_.size(), static_cast<std::size_t>(std::lround(kWaiting_s / dt_s_)));
    const auto mean_of_last = [ticks](const std::vector<double>& values) {
      double sum = 0.0;
      std::for_each(values.end() - static_cast<std::ptrdiff_t>(ticks), values.end(), [&](double v) { sum += v; });
      return sum / static_cast<double>(ticks);
    };
    out.waited_m = mean_of_last(distances_);
    out.waiting_mps = std::sqrt(mean_of_last(squares_));
    return out;
  }

 private:
  Arrival arrival_;
  Vec2 target_;
  double dt_s_ = 0.0;
  std::vector<double> distances_;
  std::vector<double> squares_;  ///< of speed
};

std::unique_ptr<Driver> driver_of(SceneDriver kind, Team team, const Config& config, const RobotLimits& limits) {
  if (kind == SceneDriver::system) return std::make_unique<SystemDriver>(team, system_params(config, team));
  if (kind == SceneDriver::chaser) return chaser(team, limits, kChaseSpeed_mps);
  return nullptr;
}

LoopSetup setup_of(const MotionScene& scene, const Config& config, std::uint64_t seed) {
  LoopSetup setup = loop_setup(config, seed);
  setup.sim.field = scene.field;
  setup.sim.robots = scene.robots;
  for (const Team team : kTeams) {
    const auto side = static_cast<std::size_t>(team);
    setup.of(team).driver = driver_of(scene.drivers.at(side), team, config, setup.sim.params.limits);
    setup.of(team).targets = source_of(scene.targets.at(side));
  }
  return setup;
}

std::vector<Watch> watches_of(const MotionScene& scene, const RobotLimits& limits) {
  std::vector<Watch> watches;
  for (const RobotPlacement& robot : scene.robots) {
    const auto side = static_cast<std::size_t>(robot.id.team);
    if (scene.drivers.at(side) != SceneDriver::system) continue;
    const Vec2& target = scene.targets.at(side).targets.at(robot.id.number).pose.position_m;
    watches.emplace_back(robot.id, robot.pose.position_m, target, limits);
  }
  return watches;
}

}  // namespace

double straight_drive_s(double distance_m, const RobotLimits& limits) {
  return trapezoid_duration(distance_m, 0.0, 0.0, limits.speed_max_mps, limits.acceleration_max_mps2,
                            limits.braking_max_mps2);
}

SceneScore play_scene(const MotionScene& scene, const SystemChoice& system, const std::string& preset,
                      std::uint64_t seed, const std::function<void(const ClosedLoop&)>& look) {
  LoopSetup setup = setup_of(scene, loop_config(system, preset), seed);
  std::vector<Watch> watches = watches_of(scene, setup.sim.params.limits);
  ClosedLoop loop(std::move(setup));
  const auto time_s = [&loop] { return to_seconds(loop.simulator().now() - Time{}); };
  SceneScore score;
  for (bool all = false; !all && time_s() < scene.limit_s;) {
    loop.tick();
    all = true;
    for (Watch& watch : watches) {
      watch.look(*find_robot(loop.truth(), watch.robot()), time_s(), loop.dt_s());
      all = all && watch.arrived();
    }
    if (look) look(loop);
  }
  for (const Watch& watch : watches) score.arrivals.push_back(watch.result());
  score.contacts = loop.simulator().contact_counts();
  score.ended_s = time_s();
  score.verdict = loop.verdict();
  return score;
}

}  // namespace regista::bench
