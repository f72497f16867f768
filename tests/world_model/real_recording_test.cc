// The world model on a recording of a real robot (50 Hz, SSL-Vision), where a developer has one: its predictions
// against "last value" and "last value + last difference". The file is a row per 20 ms: x m, y m, heading rad; its
// folder is REGISTA_DATA_DIR, else ../shared/data beside the source tree.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "tests/world_model/scene.h"
#include "world_model/prediction.h"

namespace regista {
namespace {

constexpr int kPeriod_us = 20000;

std::string data_folder() {
  if (const char* folder = std::getenv("REGISTA_DATA_DIR")) return folder;
#ifdef REGISTA_SOURCE_DIR
  return std::string(REGISTA_SOURCE_DIR) + "/../shared/data";
#else
  return "../shared/data";
#endif
}

std::vector<Pose> recording() {
  std::ifstream file(data_folder() + "/real_robot_vision_50hz.txt");
  std::vector<Pose> poses;
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  while (file >> x >> y >> heading) poses.push_back({{x, y}, heading});
  return poses;
}

/// Root mean squares of position errors in millimetres.
struct Errors {
  double model = 0.0;
  double last = 0.0;
  double difference = 0.0;
  int count = 0;

  void add(const Vec2& predicted_m, const Pose& now, const Pose& before, const Pose& truth, int steps) {
    model += (predicted_m - truth.position_m).squaredNorm();
    last += (now.position_m - truth.position_m).squaredNorm();
    const Vec2 step = now.position_m - before.position_m;
    difference += (now.position_m + steps * step - truth.position_m).squaredNorm();
    ++count;
  }
  Errors rms() const {
    const auto mm = [&](double sum) { return 1000.0 * std::sqrt(sum / count); };
    return {mm(model), mm(last), mm(difference), count};
  }
};

void print(const char* what, const Errors& errors) {
  std::cout << what << ": " << errors.model << " mm, last value " << errors.last << " mm, last + difference "
            << errors.difference << " mm (" << errors.count << " predictions)\n";
}

TEST_CASE("predictions of a real robot beat last value and last difference") {
  const std::vector<Pose> seen = recording();
  if (seen.empty()) {
    std::cout << "skipped: no recording\n";
    return;
  }
  WorldModelParams params;  // this camera hangs low over a small field: it sees better than the league's usual ones
  params.robot.position_sigma_m = 0.0004;
  params.robot.heading_sigma_rad = 0.0045;
  WorldModel world(params);
  Errors one;
  Errors four;
  Errors standing;
  // The noise parameters were tuned on the first half; only the second counts here.
  for (std::size_t i = 0; i + 5 < seen.size(); ++i) {
    const Time now = from_us(static_cast<std::int64_t>(i) * kPeriod_us);
    REQUIRE(world.add_frame(test::frame(now, static_cast<std::uint32_t>(i), {{test::kY3, seen[i], 1.0}})) ==
            FrameResult::taken);
    if (i < seen.size() / 2) continue;
    const WorldState state = world.state();
    REQUIRE(state.robots.size() == 1);
    const auto ahead = [&](int steps) {
      const Time later = state.captured + Duration{steps * kPeriod_us};
      return predicted(state.robots[0], state.captured, later, {}, {}, 0.0).pose.position_m;
    };
    const double speed_mps = (seen[i + 2].position_m - seen[i - 2].position_m).norm() / 0.08;
    if (speed_mps >= 0.1) {
      one.add(ahead(1), seen[i], seen[i - 1], seen[i + 1], 1);
      four.add(ahead(4), seen[i], seen[i - 1], seen[i + 4], 4);
    } else if (speed_mps < 0.02) {
      standing.add(ahead(1), seen[i], seen[i - 1], seen[i + 1], 1);
    }
  }
  print("moving, 20 ms ahead", one.rms());
  print("moving, 80 ms ahead", four.rms());
  print("standing, 20 ms ahead", standing.rms());
  REQUIRE(one.count > 500);
  CHECK(one.rms().model < one.rms().last / 4.0);
  CHECK(four.rms().model < four.rms().last / 3.5);
  CHECK(one.rms().model < one.rms().difference);
}

}  // namespace
}  // namespace regista
