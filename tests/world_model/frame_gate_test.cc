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

TEST_CASE("a stray stamp ahead is not believed, a silence is") {
  const FrameGateParams params;
  for (const double ahead_ms : {101.0, 300.0, 600.0, 1000.0, 3000.0, 4900.0}) {
    CAPTURE(ahead_ms);
    FrameGate gate;
    for (std::uint32_t i = 0; i <= 50; ++i)
      REQUIRE(gate.judge(frame(at_ms(10.0 * i), i, {}), params) == FrameResult::taken);
    CHECK(gate.judge(frame(at_ms(500 + ahead_ms), 51, {}), params) == FrameResult::refused);
    CHECK(gate.judge(frame(at_ms(510), 52, {}), params) == FrameResult::taken);
    CHECK(gate.newest() == at_ms(510));
    const double back_ms = 510 + ahead_ms;
    CHECK(gate.judge(frame(at_ms(back_ms), 53, {}), params) == FrameResult::refused);
    CHECK(gate.judge(frame(at_ms(back_ms + 10), 54, {}), params) == FrameResult::refused);
    CHECK(gate.judge(frame(at_ms(back_ms + 20), 55, {}), params) == FrameResult::taken);
    CHECK(gate.judge(frame(at_ms(back_ms + 30), 56, {}), params) == FrameResult::taken);
  }
}

TEST_CASE("a slow source is followed, with two cameras too, and so is one that becomes slow") {
  const FrameGateParams params;
  FrameGate gate;
  std::uint32_t number = 0;
  double ms = 0.0;
  for (; ms < 1000.0; ms += 10.0) gate.judge(frame(at_ms(ms), number++, {}), params);
  for (int i = 0; i < 200; ++i, ms += 250.0) {
    gate.judge(frame(at_ms(ms), number, {}), params);
    gate.judge(frame(at_ms(ms + 10.0), number++, {}, {}, 1), params);
  }
  CHECK(gate.counts().refused <= 4);
  CHECK(gate.counts().late == 0);
  for (; ms < 60000.0; ms += 10.0) gate.judge(frame(at_ms(ms), number++, {}), params);
  const auto refused = gate.counts().refused;
  CHECK(gate.judge(frame(at_ms(ms + 300.0), number, {}), params) == FrameResult::refused);  // a fast one again
  CHECK(gate.counts().refused == refused + 1);
}

TEST_CASE("a camera whose clock stands still is refused after its first frame") {
  const FrameGateParams params;
  FrameGate gate;
  REQUIRE(gate.judge(frame(at_ms(0), 0, {}), params) == FrameResult::taken);
  for (std::uint32_t i = 1; i < 1000; ++i) REQUIRE(gate.judge(frame(at_ms(0), i, {}), params) == FrameResult::refused);
  CHECK(gate.judge(frame(at_ms(0), 0, {}), params) == FrameResult::duplicate);
  CHECK(gate.judge(frame(at_ms(10), 1000, {}), params) == FrameResult::taken);
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
