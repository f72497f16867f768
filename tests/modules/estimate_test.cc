// How well the world model knows a field like a real one: what cameras and controllers of a whole loop said under the
// preset `realistic` goes into world models beside it, whose estimates are held against the truth at the moment they
// are for, one delay of vision and radio later.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <variant>

#include "modules/setup/module_setup.h"
#include "tests/modules/loop_fixture.h"

using namespace regista;
using namespace regista::loop_test;

namespace {

struct Recording {
  Config config;
  std::vector<std::variant<VisionFrame, TeamCommands>> messages;
  std::map<Time, WorldState> truth;  // every millisecond
};

Recording recorded(const std::vector<std::string>& settings, double seconds) {
  std::vector<std::string> all{"scenario.sim_preset=realistic"};
  all.insert(all.end(), settings.begin(), settings.end());
  Recording out{crossing(all), {}, {}};
  LockStep loop{Time{}};
  const WholeLoop modules = add_whole_loop(loop, out.config, no_time);
  const Listener<VisionFrame> vision(loop.bus(), channels::vision(),
                                     [&](VisionFrame frame) { out.messages.emplace_back(std::move(frame)); });
  const auto keep = [&](TeamCommands commands) { out.messages.emplace_back(std::move(commands)); };
  const Listener<TeamCommands> yellow(loop.bus(), channels::commands(Team::yellow), keep);
  const Listener<TeamCommands> blue(loop.bus(), channels::commands(Team::blue), keep);
  for (int ms = 0; ms < static_cast<int>(seconds * 1000.0); ++ms) {
    run_for(loop, 0.001);
    const WorldState truth = modules.sim->simulator().truth();
    out.truth.emplace(truth.captured, truth);
  }
  return out;
}

struct Accuracy {
  double position_m = 0.0;    // median error
  double velocity_mps = 0.0;  // median error
  double jump_p999_m = 0.0;   // from one estimate to the next, beside the true motion
};

double quantile(std::vector<double>& values, double part) {
  REQUIRE(values.size() > 10'000);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// From `begin_s` on: before, cameras are learnt.
Accuracy measured(const Recording& recording, bool learn, double begin_s) {
  WorldModelParams params = world_model_params_of(recording.config);
  params.cameras.learn = learn;
  WorldModel model(params);
  std::vector<double> position, velocity, jumps;
  std::map<RobotId, Vec2> last_error;
  for (const auto& message : recording.messages) {
    if (const auto* commands = std::get_if<TeamCommands>(&message)) {
      for (const RobotCommand& command : commands->commands) {
        model.add_command({commands->team, command.robot}, {commands->captured, command.velocity});
      }
      continue;
    }
    model.add_frame(std::get<VisionFrame>(message));
    const WorldState world = model.state();
    const auto truth = recording.truth.find(world.valid_at);
    if (truth == recording.truth.end() || to_seconds(world.captured - Time{}) < begin_s) continue;
    for (const RobotState& robot : world.robots) {
      const RobotState& real = *find_robot(truth->second, robot.id);
      const Vec2 error = robot.pose.position_m - real.pose.position_m;
      position.push_back(error.norm());
      velocity.push_back((robot.twist.velocity_mps - real.twist.velocity_mps).norm());
      if (last_error.count(robot.id) > 0) jumps.push_back((error - last_error[robot.id]).norm());
      last_error[robot.id] = error;
    }
  }
  return {quantile(position, 0.5), quantile(velocity, 0.5), quantile(jumps, 0.999)};
}

}  // namespace

TEST_CASE("shifted cameras that overlap cost neither jumps nor speed once they are learnt") {
  for (const char* cameras : {"2", "4"}) {
    INFO(cameras << " cameras");
    // A seed whose cameras lie more than 10 mm beside each other.
    const Recording recording = recorded({std::string("sim.vision.cameras=") + cameras, "scenario.seed=4"}, 12.0);
    const Accuracy learnt = measured(recording, true, 4.0);
    const Accuracy unlearnt = measured(recording, false, 4.0);
    CAPTURE(learnt.position_m, learnt.velocity_mps, learnt.jump_p999_m);
    CAPTURE(unlearnt.position_m, unlearnt.velocity_mps, unlearnt.jump_p999_m);
    CHECK(learnt.jump_p999_m < 0.75 * unlearnt.jump_p999_m);
    CHECK(learnt.position_m < 0.75 * unlearnt.position_m);
    CHECK(learnt.velocity_mps < 1.02 * unlearnt.velocity_mps);
    // What all cameras have in common, up to 20 mm, cannot be seen.
    CHECK(learnt.position_m < 0.02);
    CHECK(learnt.velocity_mps < 0.03);
  }
}
