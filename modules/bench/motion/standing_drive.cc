#include "modules/bench/motion/standing_drive.h"

#include "modules/bench/motion/free_move.h"
#include "modules/bench/motion/scene_run.h"
#include "modules/bench/motion/target_sources.h"
#include "modules/bench/worlds.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr std::size_t kStanding = 21;
constexpr double kApart_m = 0.5;  // between standing robots, start and target: all can be passed
constexpr double kFar_m = 3.0;
constexpr double kLimit_s = 20.0;

/// Start, target, then who stands.
std::vector<Vec2> places(const FieldGeometry& field, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const Bounds within{Vec2(field.length_m, field.width_m) / 2.0 - Vec2::Constant(0.2)};
  const auto in_area = [&field](const Vec2& place) { return !is_target_place(place, field, {}); };
  for (;;) {
    std::vector<Vec2> all = places_apart(random, within, kStanding + 2, kApart_m, in_area);
    if ((all[0] - all[1]).norm() >= kFar_m) return all;
  }
}

}  // namespace

StandingDrive drive_among_standing(const SystemChoice& system, const std::string& preset, std::uint64_t seed) {
  const Config config = loop_config(system, preset);
  LoopSetup setup = loop_setup(config, seed);
  const RobotLimits limits = setup.sim.params.limits;
  const std::vector<Vec2> at = places(setup.sim.field, seed);
  setup.sim.robots = {{{Team::yellow, 0}, {at[0], 0.0}}};
  for (std::uint16_t i = 0; i < kStanding; ++i) {
    setup.sim.robots.push_back({{Team::blue, i}, {at[i + 2U], 0.0}});
  }
  Targets targets;
  targets.team = Team::yellow;
  targets.targets = {{.robot = 0, .pose = {at[1], 0.0}}};
  setup.of(Team::yellow) = {std::make_unique<SystemDriver>(Team::yellow, system_params(config, Team::yellow)),
                            source_of(targets)};
  ClosedLoop loop(std::move(setup));
  StandingDrive out;
  std::optional<Time> began;
  while (!out.arrived_s && loop.simulator().now() < Time{} + from_seconds(kLimit_s)) {
    loop.tick();
    const std::span<const RobotPlan> plans = loop.driver(Team::yellow)->plans();
    if (!began && !plans.empty()) {
      began = loop.simulator().now();
      out.ideal_s = straight_drive_s(plans.front().plan.length_m, limits);
    }
    const RobotState& robot = *find_robot(loop.truth(), {Team::yellow, 0});
    const bool there =
        (robot.pose.position_m - at[1]).norm() <= kThere_m && robot.twist.velocity_mps.norm() < kSlow_mps;
    if (began && there) out.arrived_s = to_seconds(loop.simulator().now() - *began);
  }
  out.contacts = loop.simulator().contact_counts().opponent;
  out.verdict = loop.verdict();
  return out;
}

}  // namespace regista::bench
