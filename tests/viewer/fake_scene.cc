#include "fake_scene.h"

namespace regista {

RobotState fake_robot(Team team, std::uint16_t number) {
  const double side = team == Team::yellow ? -1.0 : 1.0;
  RobotState robot;
  robot.id = {team, number};
  robot.pose.position_m = {side * (5.0 - 2.2 * (number % 2) - 0.13 * number), -3.5 + 0.7 * number};
  robot.pose.heading_rad = wrap_angle(0.6 * number);
  robot.twist.velocity_mps = {0.5, -0.25};
  return robot;
}

RobotPlan fake_plan(const RobotState& robot, const Target& target) {
  RobotPlan plan;
  plan.robot = robot.id;
  plan.set_size = 11;
  plan.planner = "visibility_sampling";
  plan.target = target;
  plan.plan.status = PlanStatus::ok;
  const Vec2 bend = 0.5 * (robot.pose.position_m + target.pose.position_m) + Vec2(0.2, 0.5);
  plan.plan.path = {robot.pose.position_m, bend, target.pose.position_m};
  return plan;
}

GraphPicture fake_graph(Team team, const FieldGeometry& field) {
  GraphPicture graph;
  graph.team = team;
  const double shift = team == Team::yellow ? 0.0 : 0.35;
  for (int i = 0; i < 60; ++i) {
    // A low-discrepancy walk over the field: spread evenly, the same every time.
    const double u = std::fmod(0.5 + 0.754877666 * i + shift, 1.0);
    const double v = std::fmod(0.5 + 0.569840291 * i + shift, 1.0);
    graph.nodes.emplace_back((u - 0.5) * field.length_m, (v - 0.5) * field.width_m);
  }
  for (std::uint32_t a = 0; a < graph.nodes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < graph.nodes.size(); ++b) {
      const double length = (graph.nodes[a] - graph.nodes[b]).norm();
      if (length < 3.0) graph.edges.push_back({a, b, length > 2.4});
    }
  }
  return graph;
}

ViewerScene fake_scene() {
  ViewerScene scene;
  scene.world.captured = from_us(12'340'000);
  scene.world.sequence = 1;
  for (const Team team : {Team::yellow, Team::blue}) {
    TeamScene& play = scene.of(team);
    play.targets = Targets{};
    play.targets->team = team;
    for (std::uint16_t number = 0; number < 11; ++number) {
      scene.world.robots.push_back(fake_robot(team, number));
      Target target;
      target.robot = number;
      target.pose.position_m = {scene.world.robots.back().pose.position_m.x() + (team == Team::yellow ? 4.6 : -5.1),
                                3.9 - 0.75 * number};
      play.targets->targets.push_back(target);
      play.plans[number] = fake_plan(scene.world.robots.back(), target);
      play.plans[number].captured = scene.world.captured;
    }
    play.graph = fake_graph(team, scene.field);
    play.graph->captured = scene.world.captured;
    play.targets->captured = scene.world.captured;
    play.planning_robot = DurationSummary{12'300, 87'000};
    play.planning_team = DurationSummary{123'000, 870'000};
  }
  scene.world.ball = BallState{};
  scene.world.ball->position_m = {0.8, -0.6};
  return scene;
}

}  // namespace regista
