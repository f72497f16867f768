// Comparing logs: by bytes, by numbers within a tolerance, matched by channel and stamp.
#include "logs/log_compare.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "logs/log_writer.h"
#include "modules/bus/channels.h"
#include "modules/convert/commands.h"
#include "modules/convert/planning.h"
#include "modules/convert/service.h"
#include "modules/convert/world.h"
#include "tests/support/temporary_folder.h"

namespace regista {
namespace {

WorldState world_at(std::int64_t stamp_us, double x_m, double heading_rad = 0.0) {
  WorldState world;
  world.captured = from_us(stamp_us);
  world.valid_at = from_us(stamp_us);
  world.sequence = static_cast<std::uint64_t>(stamp_us);
  RobotState robot;
  robot.id = {Team::blue, 4};
  robot.pose = {{x_m, 1.0}, heading_rad};
  world.robots.push_back(robot);
  return world;
}

struct Written {
  std::string channel;
  std::vector<std::uint8_t> bytes;
};

template <class Value>
Written on(const Channel<Value>& channel, const Value& value) {
  return {channel.name, encode(value)};
}

std::vector<ChannelComparison> compare(const std::vector<Written>& a, const std::vector<Written>& b,
                                       const CompareOptions& options = {}) {
  const TemporaryFolder folder;
  for (const auto& [file, messages] : {std::pair{folder.path("a"), &a}, std::pair{folder.path("b"), &b}}) {
    LogWriter writer(file);
    for (const Written& message : *messages) writer.write(Time{}, message.channel, message.bytes);
    writer.close();
  }
  return compare_logs(folder.path("a"), folder.path("b"), options);
}

const Channel<WorldState> kWorld = channels::world_state();

TEST_CASE("a log matches itself, whatever the order of its channels") {
  const std::vector<Written> a{on(kWorld, world_at(1, 1.0)), on(channels::truth(), world_at(1, 2.0))};
  const std::vector<Written> b{a[1], a[0]};
  const auto result = compare(a, b);
  REQUIRE(result.size() == 2);
  CHECK(all_match(result));
  CHECK(result[0].matched == 1);
  CHECK(result[0].channel == "TRUTH");
}

TEST_CASE("numbers may differ by the tolerance and no more") {
  const std::vector<Written> a{on(kWorld, world_at(1, 1.0)), on(kWorld, world_at(2, 1.0))};
  const std::vector<Written> b{on(kWorld, world_at(1, 1.5)), on(kWorld, world_at(2, 1.0))};
  const auto strict = compare(a, b).front();
  CHECK(strict.different == 1);
  CHECK(strict.matched == 1);
  CHECK(strict.first_different == from_us(1));
  CHECK(strict.largest_difference == Approx(0.5));
  CHECK(compare(a, b, {"", 0.5}).front().different == 0);
  CHECK(compare(a, b, {"", 0.49}).front().different == 1);
}

TEST_CASE("headings are compared on the circle") {
  const double pi = std::numbers::pi;
  const auto result =
      compare({on(kWorld, world_at(1, 0.0, pi - 0.01))}, {on(kWorld, world_at(1, 0.0, -pi + 0.01))}, {"", 0.1}).front();
  CHECK(result.matched == 1);
  CHECK(result.largest_difference == Approx(0.02));
}

TEST_CASE("counters may differ within a tolerance, robots and planners may not") {
  WorldState other_count = world_at(1, 1.0);
  other_count.sequence = 99;
  CHECK(all_match(compare({on(kWorld, world_at(1, 1.0))}, {on(kWorld, other_count)}, {"", 0.0})));
  CHECK_FALSE(all_match(compare({on(kWorld, world_at(1, 1.0))}, {on(kWorld, other_count)})));

  WorldState other_robot = world_at(1, 1.0);
  other_robot.robots[0].id.number = 5;
  const auto result = compare({on(kWorld, world_at(1, 1.0))}, {on(kWorld, other_robot)}, {"", 1e9}).front();
  CHECK(result.different == 1);
  CHECK(std::isinf(result.largest_difference));

  RobotPlan plan;
  plan.robot = {Team::yellow, 3};
  plan.target.robot = 3;
  plan.planner = "one";
  plan.plan = {PlanStatus::ok, false, false, {{0, 0}, {1, 0}}, 1.0, ""};
  RobotPlan other_plan = plan;
  other_plan.planner = "another";
  const auto channel = channels::plan(plan.robot);
  CHECK(all_match(compare({on(channel, plan)}, {on(channel, plan)}, {"", 0.0})));
  CHECK_FALSE(all_match(compare({on(channel, plan)}, {on(channel, other_plan)}, {"", 1e9})));
}

TEST_CASE("commands are compared wheel by wheel") {
  TeamCommands commands;
  commands.captured = from_us(1);
  RobotCommand command;
  command.wheel_speeds_radps[3] = 10.0;
  commands.commands.push_back(command);
  TeamCommands other = commands;
  other.commands[0].wheel_speeds_radps[3] = 10.25;
  const auto channel = channels::commands(Team::yellow);
  const auto result = compare({on(channel, commands)}, {on(channel, other)}, {"", 0.3}).front();
  CHECK(result.matched == 1);
  CHECK(result.largest_difference == Approx(0.25));
}

TEST_CASE("missing messages are counted on both sides, repeated stamps one by one") {
  const std::vector<Written> a{on(kWorld, world_at(1, 1.0)), on(kWorld, world_at(1, 2.0)),
                               on(kWorld, world_at(2, 1.0))};
  const std::vector<Written> b{on(kWorld, world_at(1, 1.0)), on(kWorld, world_at(3, 1.0)),
                               on(kWorld, world_at(4, 1.0))};
  const auto result = compare(a, b).front();
  CHECK(result.matched == 1);
  CHECK(result.only_in_a == 2);
  CHECK(result.only_in_b == 2);
  CHECK_FALSE(all_match({result}));
}

TEST_CASE("a channel that only one log has is told") {
  const auto result = compare({}, {on(kWorld, world_at(1, 1.0))});
  REQUIRE(result.size() == 1);
  CHECK(result[0].only_in_b == 1);
  CHECK_FALSE(all_match(result));
}

TEST_CASE("channels that carry measured times are left out unless asked for") {
  const Written timing = on(channels::timing("sim"), Timing{from_us(1), "sim", 5, {}});
  CHECK(compare({timing}, {timing}).empty());
  CHECK_FALSE(all_match(compare({timing}, {timing})));
  CHECK(compare({timing}, {timing}, {"TIMING.*", {}}).size() == 1);
  CHECK(compare({timing}, {timing}, {"TIMING", {}}).empty());  // whole names
}

TEST_CASE("malformed messages are compared by their bytes") {
  const Written garbage{"WORLD_STATE", std::vector<std::uint8_t>(20, 1)};
  const Written other{"WORLD_STATE", std::vector<std::uint8_t>(21, 1)};
  CHECK(compare({garbage}, {garbage}, {"", 1.0}).front().matched == 1);
  CHECK(compare({garbage}, {other}, {"", 1.0}).front().different == 1);
}

TEST_CASE("a broken expression is refused") {
  CHECK_THROWS_WITH(compare({}, {}, {"(", {}}), Catch::Contains("is no regular expression"));
}

}  // namespace
}  // namespace regista
