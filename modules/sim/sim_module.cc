#include "modules/sim/sim_module.h"

#include "modules/bus/request_values.h"

namespace regista {
namespace {

constexpr Duration kGeometryEvery = std::chrono::seconds(1);

}  // namespace

SimModule::SimModule(Bus& bus, const SimSetup& setup)
    : Module("sim", bus),
      field_(setup.field),
      simulator_(setup),
      yellow_commands_(bus, channels::commands(Team::yellow),
                       [this](TeamCommands c) { listen(Team::yellow, std::move(c)); }),
      blue_commands_(bus, channels::commands(Team::blue),
                     [this](TeamCommands c) { listen(Team::blue, std::move(c)); }) {
  expose<SimParams>(simulator_.params(), [](const SimParams&) {
    throw RequestRefused("the simulator's parameters are fixed when it starts: restart it with --set");
  });
  answer("sim.teleport", [this](const Request& request) { return teleport(request); });
}

void SimModule::listen(Team team, TeamCommands commands) {
  // What is said on a team's channel drives that team alone.
  if (commands.team == team) commands_.emplace_back(bus().now(), std::move(commands));
}

void SimModule::on_tick(Time now) {
  for (const auto& [arrived, commands] : commands_) simulator_.command(commands, arrived);
  commands_.clear();
  announce_geometry(now);
  simulator_.advance_to(now);
  const std::vector<VisionFrame> frames = simulator_.take_frames();
  for (const VisionFrame& frame : frames) bus().publish(channels::vision(), frame);
  if (!frames.empty()) bus().publish(channels::truth(), simulator_.truth());
}

void SimModule::announce_geometry(Time now) {
  if (geometry_sent_ && now - *geometry_sent_ < kGeometryEvery) return;
  geometry_sent_ = now;
  bus().publish(channels::geometry(), {now, field_});
}

std::string SimModule::teleport(const Request& request) {
  const Pose pose = parse_pose(request.value);
  if (request.key == "ball") {
    simulator_.teleport_ball(pose.position_m, Vec2::Zero());
  } else {
    simulator_.teleport(parse_robot(request.key), pose);
  }
  return request.key + " is at " + request.value;
}

}  // namespace regista
