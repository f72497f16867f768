#include "modules/task/task_module.h"

#include <algorithm>

#include "modules/bus/request_values.h"

namespace regista {
namespace {

constexpr Duration kRepeatEvery = std::chrono::milliseconds(100);  // messages are state: any may be lost

/// The task's targets with the orders put over them.
std::vector<Target> with_orders(std::vector<Target> targets, const std::map<std::uint16_t, Target>& orders) {
  for (const auto& [robot, order] : orders) {
    const auto place =
        std::lower_bound(targets.begin(), targets.end(), robot,
                         [](const Target& target, std::uint16_t number) { return target.robot < number; });
    if (place != targets.end() && place->robot == robot) {
      *place = order;
    } else {
      targets.insert(place, order);
    }
  }
  return targets;
}

}  // namespace

TaskModule::TaskModule(Bus& bus, const Scenario& scenario)
    : Module("task", bus), scenario_(scenario), world_(bus, channels::world_state()) {
  for (const Team team : {Team::yellow, Team::blue}) {
    teams_.push_back({team, make_task(scenario, team), {}, {}, {}});
    teams_.back().last.team = team;
  }
  game_ = stated_game(scenario);
  expose<Scenario>(scenario_, [](const Scenario&) {
    throw RequestRefused("the scenario is fixed when the task starts: restart it with --set");
  });
  answer("task.goto", [this](const Request& request) { return go_to(request); });
  answer("task.release", [this](const Request& request) { return release(request); });
  answer("task.referee", [this](const Request& request) { return referee(request); });
}

std::string TaskModule::note() const { return world_.newest() == nullptr ? "waiting for WORLD_STATE" : ""; }

std::int64_t TaskModule::reached(Team team) const {
  const auto found = std::find_if(teams_.begin(), teams_.end(), [&](const TeamTask& one) { return one.team == team; });
  return regista::reached(found->task);
}

void TaskModule::on_tick(Time now) {
  if (!world_.fresh()) return;
  const WorldState& world = *world_.take();
  publish_referee_if_due(now);
  for (TeamTask& team : teams_) publish_if_due(team, world, now);
}

void TaskModule::publish_referee_if_due(Time now) {
  if (!game_ || (referee_published_ && now - *referee_published_ < kRepeatEvery)) return;
  if (!referee_published_) game_->commanded = now;
  referee_published_ = now;
  game_->sent = now;
  bus().publish(channels::referee(), *game_);
}

void TaskModule::publish_if_due(TeamTask& team, const WorldState& world, Time now) {
  std::vector<Target> wanted = with_orders(update(team.task, world).targets, team.orders);
  const bool changed = wanted != team.last.targets;
  if (!changed && team.published && now - *team.published < kRepeatEvery) return;
  if (changed) ++team.last.sequence;
  team.last.targets = std::move(wanted);
  team.last.captured = world.captured;
  team.published = now;
  bus().publish(channels::targets(team.team), team.last);
}

std::string TaskModule::go_to(const Request& request) {
  const RobotId robot = parse_robot(request.key);
  Target order;
  order.robot = robot.number;
  order.pose = parse_pose(request.value);
  if (world_.newest() == nullptr || find_robot(*world_.newest(), robot) == nullptr) {
    throw RequestRefused("no " + request.key + " on the field");
  }
  const Vec2 most = half_extent(field_of(scenario_), RobotLimits{}.radius_m);
  if ((order.pose.position_m.cwiseAbs() - most).maxCoeff() > 0.0) {
    throw RequestRefused(request.value + " is off the field: |x| up to " + std::to_string(most.x()) + " m, |y| up to " +
                         std::to_string(most.y()) + " m");
  }
  for (TeamTask& team : teams_) {
    if (team.team == robot.team) team.orders[robot.number] = order;
  }
  return request.key + " goes to " + request.value + " until told otherwise or released";
}

std::string TaskModule::release(const Request& request) {
  const RobotId robot = parse_robot(request.key);
  for (TeamTask& team : teams_) {
    if (team.team == robot.team) team.orders.erase(robot.number);
  }
  return request.key + " follows the task again";
}

std::string TaskModule::referee(const Request& request) {
  const auto named = parse_command(request.key);
  if (!named) {
    std::string known;
    for (const std::string& text : command_texts()) known += (known.empty() ? "" : ", ") + text;
    throw RequestRefused("'" + request.key + "' is no command of a referee, there are: " + known);
  }
  GameState game = game_.value_or(GameState{});
  game.command = named->command;
  game.team = named->team;
  ++game.command_counter;
  game.placement_m.reset();
  if (!request.value.empty()) game.placement_m = parse_pose(request.value).position_m;
  game_ = game;
  referee_published_.reset();
  return "the referee says " + request.key;
}

}  // namespace regista
