// The referee module over real multicast, fed with packets that protoc made, and its program as a process.
#include <catch2/catch.hpp>
#include <csignal>
#include <random>

#include "modules/bus/mailbox.h"
#include "modules/convert/referee.h"
#include "modules/convert/service.h"
#include "modules/process/real_clock.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_referee_convert.h"
#include "modules/ssl/ssl_referee_module.h"
#include "ssl_referee.pb.h"
#include "tests/ssl/module_bench.h"
#include "tests/ssl/packets.h"
#include "tests/ssl/plain_udp.h"
#include "tests/ssl/protoc.h"
#include "tests/ssl/wire.h"

using namespace regista;
using namespace std::chrono_literals;

namespace {

SslRefereeParams private_params() {
  SslRefereeParams params;
  params.group = private_group();
  params.port = private_port();
  params.interface = "lo";
  return params;
}

struct Door : TestBus {
  SslRefereeModule module{bus, private_params()};
  Queue<GameState> games{bus, channels::referee(), 100};
  MulticastSender source{private_group(), private_port()};

  std::optional<GameState> next() {
    run(module, [&] { return !games.empty(); });
    return games.pop();
  }
};

}  // namespace

TEST_CASE("a referee packet becomes a REFEREE message") {
  Door door;
  CHECK_THAT(door.module.note(), Catch::StartsWith("waiting for the referee at "));
  door.source.send(encode_referee(referee_text("BALL_PLACEMENT_BLUE", "designated_position { x: -1500.5 y: 2000 }")));
  const auto game = door.next();
  REQUIRE(game);
  CHECK(game->sent == from_us(1'700'000'000'250'000));
  CHECK(game->stage == GameStage::second_half);
  CHECK(game->command == GameCommand::ball_placement);
  CHECK(game->team == Team::blue);
  CHECK(game->command_counter == 77);
  CHECK(game->commanded == from_us(1'700'000'000'000'000));
  CHECK(game->placement_m == Vec2(-1.5005, 2.0));
  CHECK(game->yellow == TeamRecord{3, 1, 2, 0});
  CHECK(game->blue == TeamRecord{15, 4, 0, 1});
  CHECK(door.module.note() == "ball_placement_blue");
  door.source.send(encode_referee(referee_text("STOP")));
  const auto stop = door.next();
  REQUIRE(stop);
  CHECK(stop->command == GameCommand::stop);
  CHECK_FALSE(stop->team);
  CHECK_FALSE(stop->placement_m);
  door.now += 1500ms;
  CHECK_THAT(door.module.note(), Catch::EndsWith("is silent"));
}

TEST_CASE("every command of the league has its own meaning, in the league's numbers") {
  const std::vector<std::string> texts{"halt",
                                       "stop",
                                       "normal_start",
                                       "force_start",
                                       "kick_off_yellow",
                                       "kick_off_blue",
                                       "penalty_yellow",
                                       "penalty_blue",
                                       "direct_free_kick_yellow",
                                       "direct_free_kick_blue",
                                       "indirect_free_kick_yellow",
                                       "indirect_free_kick_blue",
                                       "timeout_yellow",
                                       "timeout_blue",
                                       "goal_yellow",
                                       "goal_blue",
                                       "ball_placement_yellow",
                                       "ball_placement_blue"};
  for (std::size_t code = 0; code < texts.size(); ++code) {
    // By hand, so that the numbers of our .proto are tested too; a later field of the same number counts.
    const std::string bytes = encode_referee(referee_text("HALT")) + wire::of_int(4, code);
    const GameState game = to_game_state(parse_packet<::Referee>(as_bytes(bytes)));
    CHECK(command_text(game.command, game.team) == texts[code]);
    CHECK(parse_command(texts[code]) == NamedCommand{game.command, game.team});
  }
  CHECK(command_texts().size() == texts.size());
  CHECK_FALSE(parse_command("kick_off"));
  CHECK_FALSE(parse_command(""));
}

TEST_CASE("stages too, and fields that nobody reads do not disturb") {
  for (std::uint64_t stage = 0; stage <= 13; ++stage) {
    const std::string bytes = encode_referee(referee_text("HALT")) + wire::of_int(2, stage) +
                              wire::of_bytes(18, "game-controller") + wire::of_int(19, 3) +
                              wire::of_bytes(16, std::string(200, '\1'));
    CHECK(static_cast<std::uint64_t>(to_game_state(parse_packet<::Referee>(as_bytes(bytes))).stage) == stage);
  }
}

TEST_CASE("malformed referee packets are refused, counted and leave the module running") {
  const std::string whole = encode_referee(referee_text("STOP"));
  std::mt19937_64 random(8);
  std::string noise(300, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  const std::vector<std::pair<std::string, std::string>> cases{
      {"not a well-formed", whole.substr(0, whole.size() / 2)},
      {"not a well-formed", noise},
      {"required fields missing", ""},
      {"required fields missing", encode_referee("packet_timestamp: 1 stage: POST_GAME")},
      {"x_m", encode_referee(referee_text("STOP", "designated_position { x: nan y: 0 }"))},
      {"beyond ±1000", encode_referee(referee_text("STOP", "designated_position { x: 0 y: 1e9 }"))},
      {"packet_timestamp", whole + wire::of_int(1, std::uint64_t{1} << 62)},
      {"goalkeeper", whole + wire::of_bytes(7, wire::of_int(8, 70'000))},
  };
  Door door;
  std::int64_t refused = 0;
  for (const auto& [why, bytes] : cases) {
    CAPTURE(why);
    door.source.send(bytes);
    ++refused;
    REQUIRE(door.run(door.module, [&] { return door.module.reception().refused == refused; }));
    CHECK_THAT(door.module.reception().last_refusal, Catch::Contains(why));
    CHECK(door.games.empty());
  }
  door.source.send(whole);
  CHECK(door.next());
}

TEST_CASE("the referee's group is changed while it runs") {
  Door door;
  Queue<Reply> replies(door.bus, channels::reply(), 10);
  const std::string port = std::to_string(private_port() + 1);
  door.bus.publish(channels::request(), Request{door.now, 1, "ssl-referee", "param.set", "group", "10.0.0.1"});
  door.bus.publish(channels::request(), Request{door.now, 2, "ssl-referee", "param.set", "port", port});
  REQUIRE(door.run(door.module, [&] { return !replies.empty(); }));
  CHECK_FALSE(replies.pop()->accepted);
  CHECK(replies.pop()->accepted);
  MulticastSender moved(private_group(), static_cast<std::uint16_t>(private_port() + 1));
  door.source.send(encode_referee(referee_text("HALT")));
  moved.send(encode_referee(referee_text("STOP")));
  const auto game = door.next();
  REQUIRE(game);
  CHECK(game->command == GameCommand::stop);
}

TEST_CASE("regista-ssl-referee: from group to bus, and a clean end") {
  const std::string url = private_bus();
  Bus bus(url, real_clock());
  Mailbox<GameState> game(bus, channels::referee());
  Program program({executable("regista-ssl-referee"), "--lcm-url", url, "--set", "ssl_referee.group=" + private_group(),
                   "--set", "ssl_referee.port=" + std::to_string(private_port()), "--set", "ssl_referee.interface=lo"});
  MulticastSender source(private_group(), private_port());
  const std::string packet = encode_referee(referee_text("DIRECT_FREE_YELLOW"));
  REQUIRE(eventually([&] {
    source.send(packet);
    while (bus.handle(0ms)) {
    }
    return game.newest() != nullptr;
  }));
  CHECK(game.newest()->command == GameCommand::direct_free_kick);
  CHECK(game.newest()->team == Team::yellow);
  source.send("");
  CHECK(is_alive(program.pid()));
  program.send(SIGINT);
  CHECK(program.wait() == 0);
}
