// Every message: value → bytes → value is the identity; anything else is refused without harm.
#include <catch2/catch.hpp>
#include <limits>

#include "modules/bus/channels.h"
#include "modules/convert/codec.h"
#include "tests/modules/samples.h"

using namespace regista;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Decoding either works or throws MessageError; anything else fails the test.
template <class Value>
bool is_refused(const Bytes& bytes) {
  try {
    decode<Value>(bytes);
    return false;
  } catch (const MessageError& error) {
    CHECK(std::string(error.what()) != "");
    return true;
  }
}

void put_int32(Bytes& bytes, std::size_t at, std::int32_t value) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes[at + i] = static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> (24 - 8 * i));
}

template <class Value>
void check_all(std::size_t lists) {
  samples::Source source(7);
  for (int i = 0; i < 200; ++i) {
    const Value value = samples::make<Value>(source);
    const Bytes bytes = encode(value);
    INFO("sample " << i << ", " << bytes.size() << " bytes");
    REQUIRE(decode<Value>(bytes) == value);
  }
  const Bytes bytes = encode(samples::make<Value>(source));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    INFO("cut to " << size);
    REQUIRE(is_refused<Value>(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))));
  }
  Bytes longer = bytes;
  longer.push_back(0);
  CHECK(is_refused<Value>(longer));
  Bytes foreign = bytes;
  foreign[0] ^= 1U;
  CHECK(is_refused<Value>(foreign));
  for (std::size_t list = 0; list < lists; ++list) {
    for (const std::int32_t count :
         {-1, std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()}) {
      Bytes hostile = bytes;
      put_int32(hostile, 16 + 4 * list, count);
      CHECK(is_refused<Value>(hostile));
    }
  }
  for (int i = 0; i < 3000; ++i) {  // any damage is refused or gives a value that encodes again
    Bytes damaged = bytes;
    for (std::uint64_t hits = 1 + source.below(4); hits > 0; --hits) {
      damaged[8 + source.below(damaged.size() - 8)] = static_cast<std::uint8_t>(source.below(256));
    }
    if (is_refused<Value>(damaged)) continue;
    REQUIRE_NOTHROW(encode(decode<Value>(damaged)));
  }
}

}  // namespace

TEST_CASE("VISION survives the wire") { check_all<VisionFrame>(2); }
TEST_CASE("GEOMETRY survives the wire") { check_all<FieldAnnouncement>(0); }
TEST_CASE("REFEREE survives the wire") { check_all<GameState>(0); }
TEST_CASE("WORLD_STATE survives the wire") { check_all<WorldState>(2); }
TEST_CASE("TARGETS survives the wire") { check_all<Targets>(1); }
TEST_CASE("PLAN survives the wire") { check_all<RobotPlan>(1); }
TEST_CASE("GRAPH survives the wire") { check_all<GraphPicture>(2); }
TEST_CASE("COMMANDS survives the wire") { check_all<TeamCommands>(1); }
TEST_CASE("REQUEST survives the wire") { check_all<Request>(0); }
TEST_CASE("REPLY survives the wire") { check_all<Reply>(0); }
TEST_CASE("TIMING survives the wire") { check_all<Timing>(1); }
TEST_CASE("STATUS survives the wire") { check_all<ModuleStatus>(0); }

TEST_CASE("numbers that are none are refused by name") {
  samples::Source source(1);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e9}) {
    VisionFrame frame = samples::make<VisionFrame>(source);
    frame.robots.front().pose.position_m.x() = bad;
    CHECK_THROWS_AS(decode<VisionFrame>(encode(frame)), MessageError);
    TeamCommands commands = samples::make<TeamCommands>(source);
    commands.commands.front().velocity.left_mps = bad;
    CHECK_THROWS_AS(decode<TeamCommands>(encode(commands)), MessageError);
    RobotPlan plan = samples::make<RobotPlan>(source);
    plan.plan.path.front().y() = bad;
    CHECK_THROWS_AS(decode<RobotPlan>(encode(plan)), MessageError);
  }
}

TEST_CASE("a robot that comes twice is refused") {
  samples::Source source(2);
  WorldState world = samples::make<WorldState>(source);
  world.robots.push_back(world.robots.back());
  CHECK_THROWS_WITH(decode<WorldState>(encode(world)), Catch::Contains("twice"));
}

TEST_CASE("an edge that leads out of the graph is refused") {
  samples::Source source(3);
  GraphPicture graph = samples::make<GraphPicture>(source);
  graph.edges.push_back({0, static_cast<std::uint32_t>(graph.nodes.size()), false});
  CHECK_THROWS_WITH(decode<GraphPicture>(encode(graph)), Catch::Contains("leads out"));
}

TEST_CASE("a command without its team, or a team without its command, is refused") {
  GameState game;
  game.command = GameCommand::kick_off;
  CHECK_THROWS_WITH(decode<GameState>(encode(game)), Catch::Contains("command_team"));
  game.command = GameCommand::stop;
  game.team = Team::blue;
  CHECK_THROWS_WITH(decode<GameState>(encode(game)), Catch::Contains("command_team"));
  game.team.reset();
  CHECK(decode<GameState>(encode(game)) == game);
}
