#include "publish_scene.h"

namespace regista {
namespace {

Timing timing_of(const ViewerScene& scene, Team team) {
  const TeamScene& play = scene.of(team);
  Timing timing{scene.world.captured, channels::of("planner", team), play.planning_team->max_ns, {}};
  for (std::uint16_t robot = 0; robot < 11; ++robot) {
    timing.robots.push_back({robot, robot == 5 ? play.planning_robot->max_ns : play.planning_robot->p50_ns});
  }
  return timing;
}

void publish_team(Bus& bus, const ViewerScene& scene, Team team) {
  const TeamScene& play = scene.of(team);
  if (play.targets) bus.publish(channels::targets(team), *play.targets);
  for (const auto& [number, plan] : play.plans) bus.publish(channels::plan(plan.robot), plan);
  if (play.graph) bus.publish(channels::graph(team), *play.graph);
  if (play.planning_team) {
    const Timing timing = timing_of(scene, team);
    bus.publish(channels::timing(timing.module), timing);
  }
}

}  // namespace

void publish_scene(Bus& bus, const ViewerScene& scene) {
  bus.publish(channels::geometry(), FieldAnnouncement{scene.world.captured, scene.field});
  bus.publish(channels::world_state(), scene.world);
  publish_team(bus, scene, Team::yellow);
  publish_team(bus, scene, Team::blue);
}

}  // namespace regista
