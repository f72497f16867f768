#include "modules/viewer/viewer_module.h"

#include <cstdio>

namespace regista {
namespace {

// A planner that died must not leave its paths in the picture; one slow tick must not make them blink.
constexpr Duration kPlanFresh = std::chrono::milliseconds(500);
constexpr Duration kGraphFresh = std::chrono::seconds(1);  // sent at 10 Hz or less
constexpr Duration kWorldFresh = std::chrono::seconds(1);
// A world that is this much older than the one before belongs to a new run.
constexpr Duration kRestart = std::chrono::seconds(1);

// Planning times shown are those of about the last ten seconds at 100 Hz with eleven robots.
constexpr std::size_t kRobotTimes = 11'000;
constexpr std::size_t kTeamTimes = 1'000;

bool is_near(Time a, Time b, Duration limit) { return a - b <= limit && b - a <= limit; }

void drop_stale(TeamScene& team, Time now) {
  std::erase_if(team.plans, [now](const auto& entry) { return !is_near(entry.second.captured, now, kPlanFresh); });
  if (team.graph && !is_near(team.graph->captured, now, kGraphFresh)) team.graph.reset();
}

bool is_planned(const TeamScene& team) {
  if (!team.targets || team.targets->targets.empty()) return true;
  return !team.plans.empty() && team.plans.size() >= team.plans.begin()->second.set_size;
}

}  // namespace

ViewerModule::TeamInput::TeamInput(ViewerModule& viewer, Bus& bus, Team team)
    : targets(bus, channels::targets(team),
              [&viewer, team](Targets value) {
                viewer.hear();
                viewer.latest_.of(team).targets = std::move(value);
              }),
      plans(bus, channels::plans(team),
            [&viewer, team](RobotPlan value) {
              viewer.hear();
              viewer.latest_.of(team).plans[value.robot.number] = std::move(value);
            }),
      graph(bus, channels::graph(team),
            [&viewer, team](GraphPicture value) {
              viewer.hear();
              viewer.latest_.of(team).graph = std::move(value);
            }),
      robot_times(kRobotTimes),
      team_times(kTeamTimes) {}

ViewerModule::ViewerModule(Bus& bus, OnWorldState on_world_state)
    : Module("viewer", bus),
      on_world_state_(std::move(on_world_state)),
      geometry_(bus, channels::geometry(),
                [this](const FieldAnnouncement& announcement) {
                  hear();
                  latest_.field = announcement.field;
                  field_known_ = true;
                }),
      world_(bus, channels::world_state(), [this](const WorldState& world) { take(world); }),
      timings_(bus, channels::timings(), [this](const Timing& timing) { take(timing); }),
      yellow_(*this, bus, Team::yellow),
      blue_(*this, bus, Team::blue) {}

void ViewerModule::take(const WorldState& world) {
  hear();
  if (!world_arrived_ || latest_.world.captured - world.captured > kRestart) latest_.began = world.captured;
  world_arrived_ = bus().now();
  latest_.world = world;
  if (on_world_state_) unrecorded_.push_back(scene());
}

void ViewerModule::take(const Timing& timing) {
  hear();
  for (const Team team : {Team::yellow, Team::blue}) {
    if (timing.module != channels::of("planner", team)) continue;
    TeamInput& input = input_of(team);
    for (const RobotTime& robot : timing.robots) input.robot_times.add(robot.duration_ns);
    input.team_times.add(timing.tick_ns);
  }
}

void ViewerModule::on_tick(Time) {
  fresh_ = false;
  for (const ViewerScene& recorded : unrecorded_) on_world_state_(recorded);
  unrecorded_.clear();
}

ViewerScene ViewerModule::scene() const {
  ViewerScene scene = latest_;
  for (TeamScene& team : scene.teams) drop_stale(team, scene.world.captured);
  const auto summarise = [](TeamScene& team, const TeamInput& input) {
    team.planning_robot = input.robot_times.summary();
    team.planning_team = input.team_times.summary();
  };
  summarise(scene.of(Team::yellow), yellow_);
  summarise(scene.of(Team::blue), blue_);
  scene.notice = note();
  return scene;
}

std::optional<Time> ViewerModule::world_time() const {
  return world_arrived_ ? std::optional(latest_.world.captured) : std::nullopt;
}

bool ViewerModule::complete() const {
  if (!field_known_ || !world_arrived_) return false;
  const ViewerScene shown = scene();
  return is_planned(shown.of(Team::yellow)) && is_planned(shown.of(Team::blue));
}

std::string ViewerModule::note() const {
  if (!world_arrived_) return "waiting for WORLD_STATE";
  const Duration age = bus().now() - *world_arrived_;
  if (age <= kWorldFresh) return {};
  char text[64];
  std::snprintf(text, sizeof text, "no WORLD_STATE for %.0f s", to_seconds(age));
  return text;
}

}  // namespace regista
