// Random and mutated packets: whatever comes, a parser answers or throws MessageError, and what passes makes sense.
#include <catch2/catch.hpp>
#include <random>

#include "modules/bus/service_values.h"
#include "modules/convert/referee.h"
#include "modules/convert/vision.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_geometry_convert.h"
#include "modules/ssl/ssl_radio_convert.h"
#include "modules/ssl/ssl_referee_convert.h"
#include "modules/ssl/ssl_vision_convert.h"
#include "ssl_referee.pb.h"
#include "ssl_simulation_response.pb.h"
#include "ssl_vision_wrapper.pb.h"
#include "tests/ssl/packets.h"
#include "tests/ssl/protoc.h"

using namespace regista;

namespace {

constexpr int kPackets = 10'000;

std::size_t below(std::mt19937_64& random, std::size_t limit) { return static_cast<std::size_t>(random() % limit); }

std::string random_bytes(std::mt19937_64& random, std::size_t size) {
  std::string bytes(size, '\0');
  for (char& c : bytes) c = static_cast<char>(random());
  return bytes;
}

/// One to four accidents: a flipped bit, another byte, a cut, an insertion, a doubled stretch.
std::string mutated(std::mt19937_64& random, std::string bytes) {
  for (std::size_t accidents = 1 + below(random, 4); accidents > 0 && !bytes.empty(); --accidents) {
    const std::size_t at = below(random, bytes.size());
    switch (random() % 5) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 1:
        bytes[at] = static_cast<char>(random());
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.insert(at, random_bytes(random, 1 + below(random, 8)));
        break;
      default:
        bytes.insert(at, bytes.substr(below(random, bytes.size()), 64));
        break;
    }
  }
  return bytes;
}

std::string hostile(std::mt19937_64& random, const std::vector<std::string>& good) {
  if (random() % 4 == 0) return random_bytes(random, below(random, 200));
  return mutated(random, good[below(random, good.size())]);
}

struct Verdicts {
  int taken = 0;
  int refused = 0;
};

template <class Consume>
Verdicts feed(std::uint64_t seed, const std::vector<std::string>& good, Consume consume) {
  std::mt19937_64 random(seed);
  Verdicts verdicts;
  for (int i = 0; i < kPackets; ++i) {
    const std::string bytes = hostile(random, good);
    CAPTURE(seed, i);
    try {
      consume(bytes);
      ++verdicts.taken;
    } catch (const MessageError&) {
      ++verdicts.refused;
    }
  }
  return verdicts;
}

}  // namespace

TEST_CASE("hostile vision packets do no harm, and what passes the door passes the bus") {
  const std::vector<std::string> good{encode_vision(detection_text(0, 1)), encode_vision(geometry_text()),
                                      encode_vision(detection_text(3, 2) + geometry_text(9000, 6000))};
  const Verdicts verdicts = feed(31, good, [](const std::string& bytes) {
    const auto packet = parse_packet<SSL_WrapperPacket>(as_bytes(bytes));
    if (packet.has_detection()) {
      const VisionFrame frame = to_vision_frame(packet.detection()).frame;
      REQUIRE(decode<VisionFrame>(encode(frame)) == frame);
    }
    if (packet.has_geometry()) {
      const FieldAnnouncement announcement{from_us(1), to_field_geometry(packet.geometry(), false)};
      REQUIRE(decode<FieldAnnouncement>(encode(announcement)) == announcement);
    }
  });
  CHECK(verdicts.taken > kPackets / 100);
  CHECK(verdicts.refused > kPackets / 100);
}

TEST_CASE("hostile referee packets do no harm, and what passes the door passes the bus") {
  const std::vector<std::string> good{
      encode_referee(referee_text("STOP")),
      encode_referee(referee_text("BALL_PLACEMENT_YELLOW", "designated_position { x: 1 y: 2 }"))};
  const Verdicts verdicts = feed(33, good, [](const std::string& bytes) {
    const GameState game = to_game_state(parse_packet<::Referee>(as_bytes(bytes)));
    REQUIRE(decode<GameState>(encode(game)) == game);
  });
  CHECK(verdicts.taken > kPackets / 100);
  CHECK(verdicts.refused > kPackets / 100);
}

TEST_CASE("hostile answers do no harm, and their errors stay one short line") {
  const std::vector<std::string> good{
      protoc_encode("ssl_simulation_response.proto", "RobotControlResponse",
                    R"(errors { code: "NO_SUCH_ROBOT" message: "robot 17 is not on the field" } feedback { id: 3 })")};
  const Verdicts verdicts = feed(32, good, [](const std::string& bytes) {
    for (const std::string& line : error_lines(parse_packet<::RobotControlResponse>(as_bytes(bytes)))) {
      REQUIRE(line.size() <= 210);
      REQUIRE(line.find('\n') == std::string::npos);
    }
  });
  CHECK(verdicts.taken > kPackets / 100);
  CHECK(verdicts.refused > kPackets / 100);
}
