// The whole system as processes over real multicast: up, swapping a planner, killing, recording, replaying, ending.
#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <map>
#include <mutex>
#include <thread>

#include "logs/log_compare.h"
#include "logs/log_info.h"
#include "logs/log_writer.h"
#include "modules/bus/mailbox.h"
#include "modules/convert/commands.h"
#include "modules/convert/planning.h"
#include "modules/convert/service.h"
#include "modules/convert/world.h"
#include "modules/process/real_clock.h"
#include "tests/regista/program.h"

namespace regista {
namespace {

const std::vector<std::string> kLoop{"sim",       "world-model",  "task",        "planner.Y",
                                     "planner.B", "controller.Y", "controller.B"};

/// Listens to a bus; the newest of everything, on demand.
class Ear {
 public:
  explicit Ear(const std::string& url) : bus_(url, real_clock()) {}

  /// Takes what has come in, then asks.
  bool eventually(const std::function<bool()>& holds) {
    return regista::eventually([&] {
      while (bus_.handle(Duration::zero())) {
      }
      return holds();
    });
  }

  bool all_report(const std::vector<std::string>& modules) const {
    return std::all_of(modules.begin(), modules.end(), [&](const std::string& name) { return pids_.count(name) > 0; });
  }
  int pid(const std::string& module) const { return pids_.at(module); }
  const RobotPlan* plan() const { return plan_.newest(); }
  std::int64_t commands() const { return commands_.reception().received; }
  const Targets* targets() const { return targets_.newest(); }

 private:
  Bus bus_;
  std::map<std::string, int> pids_;
  Listener<ModuleStatus> statuses_{bus_, channels::statuses(),
                                   [this](const ModuleStatus& status) { pids_[status.module] = status.pid; }};
  Mailbox<RobotPlan> plan_{bus_, channels::plans(Team::yellow)};
  Mailbox<TeamCommands> commands_{bus_, channels::commands(Team::blue)};
  Mailbox<Targets> targets_{bus_, channels::targets(Team::yellow)};
};

struct Result {
  int status;
  std::string out;
  std::string error;
};

Result regista(const std::string& url, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), executable("regista"));
  arguments.insert(arguments.end(), {"--lcm-url", url});
  Program program(arguments);
  const int status = program.wait().value_or(-1);
  return {status, program.out(), program.error()};
}

std::vector<std::string> up(const std::string& url) {
  return {executable("regista"), "up", "crossing", "--lcm-url", url};
}

TEST_CASE("up runs the loop; a planner is swapped, parameters are set, a robot is sent; Ctrl-C leaves nothing") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher(up(url));
  REQUIRE(ear.eventually([&] { return ear.all_report(kLoop) && ear.commands() > 10 && ear.plan() != nullptr; }));

  SECTION("a planner") {
    const Result use = regista(url, {"planner", "use", "rrt"});
    INFO(use.error);
    CHECK(use.status == 0);
    CHECK(ear.eventually([&] { return ear.plan()->planner == "rrt" && ear.plan()->generation == 1; }));
    const Result unknown = regista(url, {"planner", "use", "nonsense", "--team", "Y"});
    CHECK(unknown.status == 1);
    CHECK_THAT(unknown.error, Catch::Contains("rrt") && Catch::Contains("visibility_sampling"));
  }
  SECTION("parameters") {
    const Result list = regista(url, {"param", "list", "planner.Y"});
    CHECK(list.status == 0);
    CHECK_THAT(list.out, Catch::Contains("team_margin_m = "));
    CHECK(regista(url, {"param", "set", "planner.Y", "team_margin_m", "0.0625"}).status == 0);
    CHECK(regista(url, {"param", "get", "planner.Y", "team_margin_m"}).out == "0.0625\n");
    const Result unknown = regista(url, {"param", "set", "planner.Y", "team_margin", "0.0625"});
    CHECK(unknown.status == 1);
    CHECK_THAT(unknown.error, Catch::Contains("did you mean 'team_margin_m'"));
    CHECK(regista(url, {"param", "set", "planner.Y", "team_margin_m", "-1"}).status == 1);
  }
  SECTION("a robot") {
    const Result sent = regista(url, {"goto", "Y3", "1.5", "-0.25", "90"});
    INFO(sent.error);
    CHECK(sent.status == 0);
    CHECK(ear.eventually([&] {
      for (const Target& target : ear.targets()->targets) {
        if (target.robot == 3) return target.pose.position_m.isApprox(Vec2(1.5, -0.25));
      }
      return false;
    }));
    CHECK(regista(url, {"goto", "Y3", "--release"}).status == 0);
    CHECK(regista(url, {"goto", "G3", "1", "1"}).status == 1);
  }

  launcher.send(SIGINT);
  CHECK(launcher.wait() == 0);
  CHECK(processes_with(url).empty());
}

TEST_CASE("whatever is killed comes back, and the others run on") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher(up(url));
  REQUIRE(ear.eventually([&] { return ear.all_report(kLoop); }));
  std::map<std::string, int> before;
  for (const std::string& module : kLoop) before[module] = ear.pid(module);
  for (const char* victim : {"planner.Y", "sim"}) {
    kill(before[victim], SIGKILL);
    CHECK(ear.eventually([&] { return ear.pid(victim) != before[victim]; }));
    before[victim] = ear.pid(victim);
  }
  const std::int64_t commands = ear.commands();
  CHECK(ear.eventually([&] { return ear.commands() > commands + 10; }));
  for (const std::string& module : kLoop) CHECK(ear.pid(module) == before[module]);
  CHECK_THAT(launcher.out(), Catch::Contains("planner.Y was killed by signal 9"));
  launcher.send(SIGTERM);
  CHECK(launcher.wait() == 0);
  CHECK(processes_with(url).empty());
}

TEST_CASE("a scenario of a real field starts the league's protocols in the simulator's place") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher({executable("regista"), "up", "ssl", "--lcm-url", url, "--no-task"});
  CHECK(ear.eventually([&] { return ear.all_report({"ssl-vision", "ssl-radio", "world-model", "planner.B"}); }));
  CHECK(processes_with("regista-sim --lcm-url " + url).empty());
  CHECK(processes_with("regista-task --lcm-url " + url).empty());
  launcher.send(SIGINT);
  CHECK(launcher.wait() == 0);
  CHECK(processes_with(url).empty());
}

TEST_CASE("a launcher that is killed outright takes its modules with it") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher(up(url));
  REQUIRE(ear.eventually([&] { return ear.all_report(kLoop); }));
  launcher.send(SIGKILL);
  CHECK(eventually([&] { return processes_with(url).empty(); }));
}

/// The world states of a log from that long after its first on.
void write_later_states(const std::string& log, const std::string& out, Duration skipped) {
  LogReader reader(log);
  LogWriter writer(out);
  std::optional<Time> first;
  while (const auto message = reader.next()) {
    const auto stamp = stamp_of(message->bytes);
    if (message->channel != "WORLD_STATE" || !stamp) continue;
    if (!first) first = stamp;
    if (*stamp - *first >= skipped) writer.write(message->received, message->channel, message->bytes);
  }
  writer.close();
}

TEST_CASE("a run is recorded, and replayed into a fresh world model which says the same") {
  const TemporaryFolder folder;
  const std::string recording = folder.path("recording"), replayed = folder.path("replayed");
  const auto contains = [](const std::string& file, const std::string& channel, std::int64_t messages) {
    if (!std::filesystem::exists(file)) return false;
    for (const ChannelInfo& info : log_info(file).channels) {
      if (info.channel == channel) return info.messages >= messages;
    }
    return false;
  };
  {
    const std::string url = private_bus();
    Program logger({executable("regista"), "record", recording, "--lcm-url", url});
    Program launcher(up(url));
    CHECK(
        eventually([&] { return contains(recording, "WORLD_STATE", 300) && contains(recording, "COMMANDS.Y", 100); }));
    launcher.send(SIGINT);
    CHECK(launcher.wait() == 0);
    logger.send(SIGINT);
    CHECK(logger.wait() == 0);
  }
  const LogInfo info = log_info(recording);
  CHECK(info.damaged_bytes == 0);
  CHECK(contains(recording, "PLAN.B10", 50));

  const std::string url = private_bus();
  Ear ear(url);
  Program world_model({executable("regista-world-model"), "--config", "crossing", "--lcm-url", url});
  REQUIRE(ear.eventually([&] { return ear.all_report({"world-model"}); }));
  Program logger({executable("regista"), "record", replayed, "--lcm-url", url});
  REQUIRE(eventually([&] { return contains(replayed, "STATUS.world-model", 1); }));
  // At half the speed: the machine may be busy, and a message lost here is no fault.
  Program player({executable("regista"), "replay", recording, "--into", "world-model", "--without", "PLAN.*", "--speed",
                  "0.5", "--lcm-url", url});
  REQUIRE(player.wait() == 0);
  logger.send(SIGINT);
  CHECK(logger.wait() == 0);
  CHECK_FALSE(contains(replayed, "PLAN.B10", 1));
  CHECK(contains(replayed, "VISION", 100));

  // At the beginning the two differ in earnest: the recording's world model came up after the first frames.
  write_later_states(recording, folder.path("a"), std::chrono::seconds(1));
  write_later_states(replayed, folder.path("b"), std::chrono::seconds(1));
  // Metres, m/s, radians. In the same order of messages the two are equal but for rounding; on a busy machine commands
  // may have reached the recorded filter some frames later than the logger, which shows in its predictions.
  constexpr double kTolerance = 0.02;
  const auto comparison = compare_logs(folder.path("a"), folder.path("b"), {"WORLD_STATE", kTolerance});
  REQUIRE(comparison.size() == 1);
  INFO("matched " << comparison[0].matched << ", different " << comparison[0].different << ", largest "
                  << comparison[0].largest_difference);
  CHECK(comparison[0].matched >= 100);
  CHECK(comparison[0].different * 2 <= comparison[0].matched);
}

}  // namespace
}  // namespace regista
