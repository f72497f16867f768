// A recording played into a fresh module, which must say what the recorded one said.
#include <catch2/catch.hpp>
#include <csignal>

#include "logs/log_compare.h"
#include "logs/log_info.h"
#include "logs/log_writer.h"
#include "tests/regista/ear.h"

namespace regista {
namespace {

bool contains(const std::string& file, const std::string& channel, std::int64_t messages) {
  if (!std::filesystem::exists(file)) return false;
  for (const ChannelInfo& info : log_info(file).channels) {
    if (info.channel == channel) return info.messages >= messages;
  }
  return false;
}

/// A run of the whole loop, some seconds long.
void record_run(const std::string& recording) {
  const std::string url = private_bus();
  Program logger({executable("regista"), "record", recording, "--lcm-url", url});
  Program launcher(up(url));
  CHECK(eventually([&] { return contains(recording, "WORLD_STATE", 300) && contains(recording, "COMMANDS.Y", 100); }));
  launcher.send(SIGINT);
  CHECK(launcher.wait() == 0);
  logger.send(SIGINT);
  CHECK(logger.wait() == 0);
}

struct Fresh {
  std::string module;
  std::vector<std::string> command;
  std::vector<std::string> without;  ///< channels not to be played to it
};

/// Plays the recording to the module and writes what was said then to `replayed`.
void replay_into(const Fresh& fresh, const std::string& recording, const std::string& replayed) {
  const std::string url = private_bus();
  const auto on_bus = [&](std::vector<std::string> command) {
    command.insert(command.end(), {"--lcm-url", url});
    return command;
  };
  Ear ear(url);
  Program module(on_bus(fresh.command));
  REQUIRE(ear.eventually([&] { return ear.all_report({fresh.module}); }));
  Program logger(on_bus({executable("regista"), "record", replayed}));
  REQUIRE(eventually([&] { return contains(replayed, "STATUS." + fresh.module, 1); }));
  // At half the speed: the machine may be busy, and a message lost here is no fault.
  std::vector<std::string> play{executable("regista"), "replay", recording, "--into", fresh.module, "--speed", "0.5"};
  for (const std::string& channels : fresh.without) play.insert(play.end(), {"--without", channels});
  REQUIRE(run(on_bus(play)).status == 0);
  logger.send(SIGINT);
  CHECK(logger.wait() == 0);
}

/// The messages of one channel of a log from that long after the first on.
void write_later(const std::string& log, const std::string& out, const std::string& channel, Duration skipped) {
  LogReader reader(log);
  LogWriter writer(out);
  std::optional<Time> first;
  while (const auto message = reader.next()) {
    const auto stamp = stamp_of(message->bytes);
    if (message->channel != channel || !stamp) continue;
    if (!first) first = stamp;
    if (*stamp - *first >= skipped) writer.write(message->received, message->channel, message->bytes);
  }
  writer.close();
}

struct Agreement {
  std::int64_t same = 0;
  std::int64_t different = 0;  ///< of the same stamp, but apart by more than the tolerance
};

Agreement agreement(const std::string& a, const std::string& b, const CompareOptions& options) {
  Agreement all;
  for (const ChannelComparison& channel : compare_logs(a, b, options)) {
    UNSCOPED_INFO(channel.channel << ": same " << channel.matched << ", different " << channel.different
                                  << ", only recorded " << channel.only_in_a << ", only replayed " << channel.only_in_b
                                  << ", largest difference " << channel.largest_difference);
    all.same += channel.matched;
    all.different += channel.different;
  }
  return all;
}

TEST_CASE("a run is recorded, and replayed into fresh modules which say the same") {
  const TemporaryFolder folder;
  const std::string recording = folder.path("recording"), replayed = folder.path("replayed");
  record_run(recording);
  CHECK(log_info(recording).damaged_bytes == 0);
  REQUIRE(contains(recording, "PLAN.B10", 50));

  SECTION("world model") {
    replay_into({"world-model", {executable("regista-world-model"), "--config", "crossing"}, {"PLAN.*"}}, recording,
                replayed);
    CHECK_FALSE(contains(replayed, "PLAN.B10", 1));
    CHECK(contains(replayed, "VISION", 100));
    // At the beginning the two differ in earnest: the recording's world model came up after the first frames.
    write_later(recording, folder.path("a"), "WORLD_STATE", std::chrono::seconds(1));
    write_later(replayed, folder.path("b"), "WORLD_STATE", std::chrono::seconds(1));
    // Metres, m/s, radians. In the same order of messages the two are equal but for rounding; on a busy machine
    // commands may have reached the recorded filter some frames later than the logger, which shows in its predictions.
    constexpr double kTolerance = 0.02;
    const Agreement states = agreement(folder.path("a"), folder.path("b"), {"WORLD_STATE", kTolerance});
    CHECK(states.same >= 100);
    CHECK(states.different * 3 <= states.same);
  }
  SECTION("planner") {
    replay_into({"planner.Y", {executable("regista-planner"), "--team", "Y", "--config", "crossing"}, {}}, recording,
                replayed);
    CHECK(contains(replayed, "PLAN.B10", 50));
    // Metres, m/s, radians. A plan is a function of the world state and of the newest targets, so the two are equal to
    // the last bit, save where a target changes: there the recorded planner may have had the world state first and the
    // fresh one the targets. One in ten is far more than the changes of target in a run. Who skips a world state on a
    // busy machine has no plan of that stamp to be compared.
    constexpr double kTolerance = 1e-9;
    const Agreement plans = agreement(recording, replayed, {"PLAN\\.Y[0-9]+", kTolerance});
    CHECK(plans.same >= 500);
    CHECK(plans.different * 9 <= plans.same);
  }
}

}  // namespace
}  // namespace regista
