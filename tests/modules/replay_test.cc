// Logs of lock-step runs: the same seed gives the same bytes, and a replay into fresh modules the recorded answers.
#include "modules/lockstep/replay.h"

#include <catch2/catch.hpp>

#include "tests/modules/loop_fixture.h"
#include "tests/support/temporary_folder.h"

using namespace regista;
using namespace regista::loop_test;

namespace {

/// Where two lists of messages part, for people; empty when they do not.
std::string first_difference(const Replay& replay) {
  const std::size_t common = std::min(replay.recorded.size(), replay.replayed.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (replay.recorded[i] == replay.replayed[i]) continue;
    return "message " + std::to_string(i) + ": recorded " + replay.recorded[i].channel + " at " +
           std::to_string(to_us(replay.recorded[i].received)) + " us, replayed " + replay.replayed[i].channel + " at " +
           std::to_string(to_us(replay.replayed[i].received)) + " us";
  }
  if (replay.recorded.size() == replay.replayed.size()) return "";
  return std::to_string(replay.recorded.size()) + " recorded, " + std::to_string(replay.replayed.size()) + " replayed";
}

}  // namespace

TEST_CASE("same seed, same log, byte for byte; another seed, another log") {
  const TemporaryFolder folder;
  const auto run = [&](const std::string& name, const std::string& seed) {
    const std::string file = folder.path(name);
    run_scenario(crossing({"scenario.duration_s=3", seed, "scenario.expect.targets_per_team_min=0"}),
                 {.log_file = file}, real_stopwatch());
    return bytes_of(file);
  };
  const std::string first = run("first.lcmlog", "scenario.seed=5");
  CHECK(first.size() > 100'000);
  CHECK(first == run("second.lcmlog", "scenario.seed=5"));
  CHECK(first != run("third.lcmlog", "scenario.seed=6"));
}

TEST_CASE("a configuration that is refused costs no older log") {
  const TemporaryFolder folder;
  const std::string log = folder.path("run.lcmlog");
  std::ofstream(log) << "precious";
  CHECK_THROWS_AS(run_scenario(crossing({"planner.use=rr"}), {.log_file = log}, no_time), ConfigError);
  CHECK(bytes_of(log) == "precious");
}

TEST_CASE("a log replayed into fresh modules gives the recorded outputs, byte for byte") {
  const TemporaryFolder folder;
  const std::string log = folder.path("run.lcmlog");
  const std::string referee = GENERATE("", "direct_free_kick_blue");
  CAPTURE(referee);
  const Config config =
      crossing({"scenario.duration_s=3", "scenario.expect.targets_per_team_min=0", "scenario.referee=" + referee});
  run_scenario(config, {.log_file = log}, no_time);

  const auto check = [&](const std::string& outputs, const std::function<void(LockStep&)>& add) {
    INFO(outputs);
    const Replay replay = replay_log(log, outputs, add);
    CHECK(replay.recorded.size() > 50);
    CHECK(first_difference(replay) == "");
  };
  check("WORLD_STATE", [&](LockStep& loop) { add_world_model(loop, config, no_time); });
  check("TARGETS\\..|REFEREE", [&](LockStep& loop) { add_task(loop, config); });
  check("(PLAN|GRAPH)\\.Y.*", [&](LockStep& loop) { add_planner(loop, config, Team::yellow, no_time); });
  check("COMMANDS\\.B", [&](LockStep& loop) { add_controller(loop, config, Team::blue, no_time); });
  check("(PLAN|GRAPH|COMMANDS)\\..*", [&](LockStep& loop) {
    for (const Team team : {Team::yellow, Team::blue}) add_planner(loop, config, team, no_time);
    for (const Team team : {Team::yellow, Team::blue}) add_controller(loop, config, team, no_time);
  });
}

TEST_CASE("a replay with another parameter is seen to differ") {
  const TemporaryFolder folder;
  const std::string log = folder.path("run.lcmlog");
  run_scenario(crossing({"scenario.duration_s=2", "scenario.expect.targets_per_team_min=0"}), {.log_file = log},
               no_time);
  const Config other = crossing({"planner.team_margin_m=0.2"});
  const Replay replay =
      replay_log(log, "(PLAN|GRAPH)\\.Y.*", [&](LockStep& loop) { add_planner(loop, other, Team::yellow, no_time); });
  CHECK(first_difference(replay) != "");
}
