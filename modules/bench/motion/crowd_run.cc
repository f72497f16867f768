#include "modules/bench/motion/crowd_run.h"

#include <array>
#include <stdexcept>

#include "modules/bench/motion/cpu_time.h"
#include "modules/bench/motion/simple_drivers.h"
#include "modules/bench/motion/target_sources.h"

namespace regista::bench {
namespace {

constexpr double kStrollSpeed_mps = 2.0;
constexpr double kChaseSpeed_mps = 3.0;

// Streams of a game's seed: below 16 the simulator's.
constexpr std::uint64_t kTargetsStream = 16;

constexpr std::array kNames{"system", "random", "chaser", "none"};

RandomTargets random_targets(Team team, const FieldGeometry& field, double speed_max_mps, std::uint64_t seed) {
  RandomTargetsParams params;
  params.speed_max_mps = speed_max_mps;
  return {team, field, params, mixed(seed, kTargetsStream + static_cast<std::uint64_t>(team))};
}

std::unique_ptr<Driver> opponents(Opponents kind, const Config& config, const RobotLimits& limits) {
  if (kind == Opponents::system) {
    return std::make_unique<SystemDriver>(Team::blue, system_params(config, Team::blue));
  }
  if (kind == Opponents::chaser) return chaser(Team::blue, limits, kChaseSpeed_mps);
  return straight_driver(Team::blue, limits);
}

void set_drivers(LoopSetup& setup, Opponents kind, const Config& config) {
  const SystemParams ours = system_params(config, Team::yellow);
  if (kind == Opponents::none) {
    setup.sim.robots_collide = false;
    std::erase_if(setup.sim.robots, [](const RobotPlacement& robot) { return robot.id.team == Team::blue; });
    setup.of(Team::yellow).driver = std::make_unique<PassThroughDriver>(Team::yellow, ours);
    return;
  }
  setup.of(Team::yellow).driver = std::make_unique<SystemDriver>(Team::yellow, ours);
  setup.of(Team::blue).driver = opponents(kind, config, setup.sim.params.limits);
}

}  // namespace

const char* name(Opponents opponents) { return kNames.at(static_cast<std::size_t>(opponents)); }

Opponents opponents_of(const std::string& name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames.at(i)) return static_cast<Opponents>(i);
  }
  throw std::invalid_argument("unknown opponents '" + name + "', there are: system, random, chaser, none");
}

CrowdScore& CrowdScore::operator+=(const CrowdScore& other) {
  minutes += other.minutes;
  robot_minutes += other.robot_minutes;
  reached += other.reached;
  contacts += other.contacts;
  times.insert(times.end(), other.times.begin(), other.times.end());
  cpu_s += other.cpu_s;
  verdict += other.verdict;
  return *this;
}

CrowdScore play_crowd(const CrowdGame& game, const SystemChoice& system, double minutes, std::uint64_t seed) {
  const CpuShot cpu;
  const Config config = loop_config(system, game.preset, game.division);
  LoopSetup setup = loop_setup(config, seed);
  const FieldGeometry field = setup.sim.field;
  const RobotLimits limits = setup.sim.params.limits;
  RandomTargets ours = random_targets(Team::yellow, field, limits.speed_max_mps, seed);
  RandomTargets theirs = random_targets(
      Team::blue, field, game.opponents == Opponents::random ? kStrollSpeed_mps : limits.speed_max_mps, seed);
  set_drivers(setup, game.opponents, config);
  setup.of(Team::yellow).targets = source_of(ours);
  setup.of(Team::blue).targets = source_of(theirs);

  ClosedLoop loop(std::move(setup));
  ContactWatch watch(Team::yellow, limits.radius_m);
  loop.run_for(60.0 * minutes, [&] { watch.observe(loop.simulator(), loop.truth(), loop.dt_s()); });
  CrowdScore score;
  score.minutes = minutes;
  score.robot_minutes = minutes * static_cast<double>(loop.targets(Team::yellow).targets.size());
  score.reached = ours.reached();
  score.contacts = watch.tally();
  const std::span<const DriveTime> times = loop.driver(Team::yellow)->times();
  score.times.assign(times.begin(), times.end());
  score.cpu_s = cpu.s();
  score.verdict = loop.verdict();
  return score;
}

}  // namespace regista::bench
