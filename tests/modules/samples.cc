#include "tests/modules/samples.h"

using namespace regista;

namespace samples {
namespace {

Time time(Source& s) { return from_us(static_cast<std::int64_t>(s.below(2'000'000'000'000'000))); }
Vec2 point(Source& s) { return {s.within(-7.0, 7.0), s.within(-5.0, 5.0)}; }
Pose pose(Source& s) { return {point(s), wrap_angle(s.within(-3.1, 3.1))}; }
Team team(Source& s) { return s.coin() ? Team::yellow : Team::blue; }
std::uint64_t length(Source& s) { return 2 + s.below(20); }

Target target(Source& s, std::uint64_t robot) {
  return {static_cast<std::uint16_t>(robot), pose(s), s.within(0.0, 3.0), s.coin()};
}

}  // namespace

template <>
VisionFrame make(Source& s) {
  VisionFrame frame{
      time(s), time(s), static_cast<std::uint32_t>(s.below(8)), static_cast<std::uint32_t>(s.below(1U << 31U)), {}, {}};
  for (std::uint64_t i = length(s); i > 0; --i) {
    frame.robots.push_back({{team(s), static_cast<std::uint16_t>(s.below(65536))}, pose(s), s.within(0.0, 1.0)});
  }
  for (std::uint64_t i = length(s); i > 0; --i) frame.balls.push_back({point(s), s.within(0.0, 1.0)});
  return frame;
}

template <>
FieldAnnouncement make(Source& s) {
  FieldAnnouncement announcement{time(s), s.coin() ? division_a() : division_b()};
  announcement.field.length_m = s.within(1.0, 100.0);
  announcement.field.yellow_on_positive_x = s.coin();
  return announcement;
}

template <>
GameState make(Source& s) {
  GameState game;
  game.sent = time(s);
  game.stage = static_cast<GameStage>(s.below(14));
  game.command = static_cast<GameCommand>(s.below(11));
  if (is_of_a_team(game.command)) game.team = team(s);
  game.command_counter = static_cast<std::uint32_t>(s.below(1U << 31U));
  game.commanded = time(s);
  if (s.coin()) game.placement_m = point(s);
  for (TeamRecord* record : {&game.yellow, &game.blue}) {
    *record = {static_cast<std::uint16_t>(s.below(65536)), static_cast<std::uint32_t>(s.below(11)),
               static_cast<std::uint32_t>(s.below(3)), static_cast<std::uint32_t>(s.below(3))};
  }
  return game;
}

template <>
WorldState make(Source& s) {
  WorldState world{time(s), time(s), s.below(1'000'000), {}, {}};
  for (std::uint64_t i = length(s), number = 0; i > 0; --i, number += 1 + s.below(1000)) {
    world.robots.push_back({{Team::blue, static_cast<std::uint16_t>(number)},
                            pose(s),
                            {point(s), s.within(-10.0, 10.0)},
                            s.within(0.0, 1.0),
                            s.within(0.0, 1.0),
                            s.within(0.0, 1.0),
                            Duration{static_cast<std::int64_t>(s.below(1'000'000))}});
  }
  world.ball = BallState{point(s), point(s), s.within(0.0, 1.0), s.within(0.0, 1.0), Duration{5}};
  return world;
}

template <>
Targets make(Source& s) {
  Targets targets{time(s), team(s), s.below(1000), {}};
  for (std::uint64_t i = length(s), robot = 0; i > 0; --i, robot += 1 + s.below(100)) {
    targets.targets.push_back(target(s, robot));
  }
  return targets;
}

template <>
RobotPlan make(Source& s) {
  RobotPlan plan;
  plan.robot = {team(s), static_cast<std::uint16_t>(s.below(65536))};
  plan.captured = time(s);
  plan.world_sequence = s.below(1000);
  plan.targets_sequence = s.below(1000);
  plan.set_size = static_cast<std::uint32_t>(1 + s.below(100));
  plan.planner = s.word();
  plan.generation = s.below(10);
  plan.target = target(s, plan.robot.number);
  plan.plan.status = static_cast<PlanStatus>(s.below(4));
  plan.plan.start_moved = s.coin();
  plan.plan.goal_moved = s.coin();
  for (std::uint64_t i = length(s); i > 0; --i) plan.plan.path.push_back(point(s));
  plan.plan.length_m = s.within(0.0, 30.0);
  plan.plan.reason = s.word();
  return plan;
}

template <>
GraphPicture make(Source& s) {
  GraphPicture graph{time(s), team(s), s.below(1000), {}, {}};
  for (std::uint64_t i = length(s); i > 0; --i) graph.nodes.push_back(point(s));
  for (std::uint64_t i = length(s); i > 0; --i) {
    graph.edges.push_back({static_cast<std::uint32_t>(s.below(graph.nodes.size())),
                           static_cast<std::uint32_t>(s.below(graph.nodes.size())), s.coin()});
  }
  return graph;
}

template <>
TeamCommands make(Source& s) {
  TeamCommands commands{time(s), team(s), s.below(1000), s.below(1000), {}};
  for (std::uint64_t i = length(s), robot = 0; i > 0; --i, robot += 1 + s.below(100)) {
    RobotCommand command;
    command.robot = static_cast<std::uint16_t>(robot);
    command.velocity = {s.within(-3.0, 3.0), s.within(-3.0, 3.0), s.within(-10.0, 10.0)};
    for (double& wheel : command.wheel_speeds_radps) wheel = s.within(-100.0, 100.0);
    command.kick_speed_mps = s.within(0.0, 6.5);
    command.dribbler_radps = s.within(0.0, 1000.0);
    commands.commands.push_back(command);
  }
  return commands;
}

template <>
Request make(Source& s) {
  return {time(s), static_cast<std::int64_t>(s.below(1U << 31U)), s.word(), s.word(), s.word(), s.word()};
}

template <>
Reply make(Source& s) {
  return {time(s), static_cast<std::int64_t>(s.below(1U << 31U)), s.coin(), s.word(), s.word()};
}

template <>
Timing make(Source& s) {
  Timing timing{time(s), s.word(), static_cast<std::int64_t>(s.below(1'000'000)), {}};
  for (std::uint64_t i = length(s); i > 0; --i) {
    timing.robots.push_back({static_cast<std::uint16_t>(i), static_cast<std::int64_t>(s.below(1'000'000))});
  }
  return timing;
}

template <>
ModuleStatus make(Source& s) {
  ModuleStatus status;
  status.sent = time(s);
  status.module = s.word();
  status.host = s.word();
  status.pid = static_cast<std::int32_t>(s.below(100000));
  status.uptime = Duration{static_cast<std::int64_t>(s.below(1'000'000'000))};
  status.rate_hz = s.within(0.0, 100.0);
  status.tick_p50_ns = static_cast<std::int64_t>(s.below(1'000'000));
  status.refused = static_cast<std::int64_t>(s.below(1000));
  status.note = s.word();
  return status;
}

}  // namespace samples
