// When the simulator's frames come: rate, latency, numbers, several cameras.
#include <catch2/catch.hpp>

#include "sim/simulator.h"
#include "tests/sim/one_robot.h"

namespace regista {
namespace {

using test::one_robot;

TEST_CASE("frames come at the rate, numbered, exactly a latency after they were captured") {
  SimParams params;
  params.vision.latency_s = 0.045;
  SimSetup setup = one_robot(params);
  setup.start = from_us(777);
  Simulator simulator(setup);
  CHECK(simulator.take_frames().empty());
  for (std::uint32_t k = 0; k < 20; ++k) {
    const Time due = simulator.next_frame_due();
    CHECK(due == from_us(777 + 10'000 * k + 45'000));
    simulator.advance_to(due - Duration{1});
    CHECK(simulator.take_frames().empty());
    simulator.advance_to(due);
    const auto frames = simulator.take_frames();
    REQUIRE(frames.size() == 1);
    CHECK(frames[0].frame_number == k);
    CHECK(frames[0].captured == due - Duration{45'000});
    CHECK(frames[0].sent == due);
  }
  simulator.advance_to(simulator.now() + Duration{35'000});
  CHECK(simulator.take_frames().size() == 3);
}

TEST_CASE("a rate that is no multiple of the step: captured at the first step after it is due") {
  SimParams params;
  params.vision.rate_hz = 60.0;
  params.vision.latency_s = 0.0333333;
  Simulator simulator(one_robot(params));
  for (int k = 0; k < 60; ++k) {
    simulator.advance_to(simulator.next_frame_due());
    const auto frames = simulator.take_frames();
    REQUIRE(frames.size() == 1);
    const Duration late = frames[0].captured.time_since_epoch() - from_seconds(k / 60.0);
    CHECK(late >= Duration{0});
    CHECK(late < kSimStep);
    CHECK(frames[0].sent <= simulator.now());
  }
}

TEST_CASE("several cameras take turns, each at the rate, each with its own number and view") {
  SimParams params = sim_preset("realistic");
  params.vision.cameras = 4;
  params.vision.robot_dropout = 0.0;
  SimSetup setup = one_robot(params);  // at (-3, 1): in the upper left quarter
  Simulator simulator(setup);
  std::vector<std::int64_t> frames(4, 0);
  Time last = Time{} - Duration{1};
  for (int k = 0; k < 400; ++k) {
    const Time due = simulator.next_frame_due();
    simulator.advance_to(due);
    for (const VisionFrame& frame : simulator.take_frames()) {
      REQUIRE(frame.camera < 4);
      CHECK(frame.captured > last);
      last = frame.captured;
      CHECK(frame.frame_number == frames[frame.camera]++);
      CHECK(frame.robots.size() == (frame.camera == 2 ? 1 : 0));
    }
  }
  CHECK(frames == std::vector<std::int64_t>(4, 100));
  CHECK(last - Time{} < Duration{1'000'000});
}

}  // namespace
}  // namespace regista
