// Which frames enter by their stamps.
#include "world_model/frame_gate.h"

#include <catch2/catch.hpp>

#include "tests/world_model/scene.h"

namespace regista {
namespace {

using test::at_ms;
using test::frame;

TEST_CASE("duplicates and late frames are told apart and move nothing") {
  FrameGate gate;
  const FrameGateParams params;
  CHECK(gate.judge(frame(at_ms(1000), 1, {}), params) == FrameResult::taken);
  CHECK(gate.judge(frame(at_ms(1010), 2, {}), params) == FrameResult::taken);
  CHECK(gate.judge(frame(at_ms(1000), 1, {}), params) == FrameResult::duplicate);
  CHECK(gate.judge(frame(at_ms(1010), 2, {}), params) == FrameResult::duplicate);
  CHECK(gate.judge(frame(at_ms(1010), 2, {}, {}, 1), params) == FrameResult::taken);  // another camera
  CHECK(gate.judge(frame(at_ms(960), 7, {}, {}, 1), params) == FrameResult::taken);
  CHECK(gate.judge(frame(at_ms(959), 8, {}, {}, 1), params) == FrameResult::late);
  CHECK(gate.judge(frame(at_ms(10), 9, {}), params) == FrameResult::late);
  CHECK(gate.newest() == at_ms(1010));
}

TEST_CASE("a clock set anew is followed after a few frames that agree") {
  const FrameGateParams params;
  for (const double start_ms : {0.0, 100000.0}) {
    FrameGate gate;
    REQUIRE(gate.judge(frame(at_ms(50000), 1, {}), params) == FrameResult::taken);
    CHECK(gate.judge(frame(at_ms(start_ms), 1, {}), params) == FrameResult::refused);
    CHECK(gate.judge(frame(at_ms(start_ms), 1, {}), params) == FrameResult::refused);  // repeated: confirms nothing
    CHECK(gate.judge(frame(at_ms(start_ms + 10), 2, {}), params) == FrameResult::refused);
    CHECK(gate.judge(frame(at_ms(start_ms + 20), 3, {}), params) == FrameResult::restarted);
    CHECK(gate.newest() == at_ms(start_ms + 20));
    CHECK(gate.judge(frame(at_ms(start_ms + 30), 4, {}), params) == FrameResult::taken);
  }
}

TEST_CASE("stray stamps among good ones never reset") {
  FrameGate gate;
  const FrameGateParams params;
  for (std::uint32_t i = 0; i < 100; ++i) {
    REQUIRE(gate.judge(frame(at_ms(10.0 * i), i, {}), params) == FrameResult::taken);
    REQUIRE(gate.judge(frame(at_ms(1e6 + 10.0 * i), i, {}, {}, 1), params) == FrameResult::refused);
  }
}

TEST_CASE("a first frame far in the future does not lock out those that follow") {
  FrameGate gate;
  const FrameGateParams params;
  REQUIRE(gate.judge(frame(at_ms(1e9), 0, {}), params) == FrameResult::taken);
  int refused = 0;
  for (std::uint32_t i = 0; i < 10; ++i) {
    refused += gate.judge(frame(at_ms(10.0 * i), i, {}), params) == FrameResult::refused ? 1 : 0;
  }
  CHECK(refused == 2);
  CHECK(gate.newest() == at_ms(90));
}

}  // namespace
}  // namespace regista
