// Cameras that lie beside each other: learnt from what two of them see, and no motion to the robots.
#include "world_model/camera_alignment.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/random.h"
#include "world_model/world_model.h"

namespace regista {
namespace {

Vec2 drawn(Random& random, double size) {
  const double x = random.uniform(-size, size);
  return {x, random.uniform(-size, size)};
}

TEST_CASE("differences between linked cameras are learnt, whatever the links, and add up to nothing in common") {
  const CameraAlignmentParams params;
  const std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> links{
      {{7, 3}}, {{0, 1}, {1, 2}, {2, 3}}, {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {0, 3}, {1, 2}}, {{5, 1}, {5, 2}, {5, 3}}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const auto& linked : links) {
      INFO("seed " << seed << ", " << linked.size() << " links");
      Random random(seed);
      std::map<std::uint32_t, Vec2> shifts;
      CameraAlignment alignment;
      for (int i = 0; i < 200; ++i) {
        for (const auto& [a, b] : linked) {
          for (const std::uint32_t camera : {a, b}) shifts.try_emplace(camera, drawn(random, 0.02));
          const Vec2 place = drawn(random, 4.0);
          const auto noise = [&] { return Vec2(0.0013 * random.normal(), 0.0013 * random.normal()); };
          alignment.compare(a, place + shifts[a] + noise(), b, place + shifts[b] + noise(), params);
        }
      }
      Vec2 sum = Vec2::Zero();
      for (const auto& [a, shift] : shifts) {
        sum += alignment.shift_m(a);
        for (const auto& [b, other] : shifts) {
          // Five standard errors of three links in a row: 5 · 1.3 mm · √2 · √3 / √200 = 1.1 mm.
          CHECK((alignment.shift_m(b) - alignment.shift_m(a) - (other - shift)).norm() < 0.0012);
        }
      }
      CHECK(sum.norm() < 1e-9);
    }
  }
}

TEST_CASE("a camera nobody was compared with is where it says; two groups do not move each other") {
  const CameraAlignmentParams params;
  CameraAlignment alignment;
  CHECK(alignment.shift_m(4) == Vec2::Zero());
  for (int i = 0; i < 1000; ++i) {
    alignment.compare(0, {0.0, 0.0}, 1, {0.02, 0.0}, params);
    alignment.compare(2, {0.0, 0.0}, 3, {0.0, 0.01}, params);
  }
  CHECK((alignment.shift_m(0) - Vec2(-0.01, 0.0)).norm() < 1e-5);
  CHECK((alignment.shift_m(1) - Vec2(0.01, 0.0)).norm() < 1e-5);
  CHECK((alignment.shift_m(3) - Vec2(0.0, 0.005)).norm() < 1e-5);
  CHECK(alignment.shift_m(4) == Vec2::Zero());
}

TEST_CASE("one comparison takes most of a difference, and who looks first does not matter") {
  const CameraAlignmentParams params;
  CameraAlignment one, other;
  one.compare(0, {1.0, 1.0}, 1, {1.02, 1.0}, params);
  other.compare(1, {1.02, 1.0}, 0, {1.0, 1.0}, params);
  CHECK((one.shift_m(1) - one.shift_m(0)).x() > 0.9 * 0.02);
  CHECK((one.shift_m(1) - other.shift_m(1)).norm() < 1e-12);
}

TEST_CASE("a camera that is knocked is followed") {
  CameraAlignmentParams params;
  params.memory_pairs = 100.0;
  CameraAlignment alignment;
  for (int i = 0; i < 10'000; ++i) alignment.compare(0, {0, 0}, 1, {0.01, 0}, params);
  for (int i = 0; i < 500; ++i) alignment.compare(0, {0, 0}, 1, {-0.01, 0}, params);
  CHECK((alignment.shift_m(1) - alignment.shift_m(0)).x() < -0.0095);
}

/// Robots that drive to and fro across the middle, seen by two cameras that overlap by 0.3 m there, 100 Hz each in
/// turn.
struct Errors {
  double fastest_wrong_mps = 0.0;  // largest error of a velocity
  double jump_m = 0.0;             // largest step of a position beside the robot's own motion
};

Errors driven(bool learn, double shift_max_m, std::uint64_t seed) {
  constexpr int kRobots = 4;
  Random random(seed);
  const std::array<Vec2, 2> shifts{drawn(random, shift_max_m), drawn(random, shift_max_m)};
  WorldModelParams params;
  params.cameras.learn = learn;
  WorldModel model(params);
  Errors errors;
  std::map<RobotId, Vec2> last_error;
  for (int frame = 0; frame < 4000; ++frame) {
    const double t = frame * 0.005;
    VisionFrame seen;
    seen.captured = Time{} + from_seconds(t);
    seen.camera = static_cast<std::uint32_t>(frame % 2);
    seen.frame_number = static_cast<std::uint32_t>(frame / 2);
    std::map<RobotId, std::pair<Vec2, Vec2>> truth;
    for (std::uint16_t i = 0; i < kRobots; ++i) {
      const double phase = 0.8 * t + i;
      const RobotId id{Team::yellow, i};
      truth[id] = {{1.5 * std::sin(phase), i - 1.5}, {1.2 * std::cos(phase), 0.0}};
      const Vec2 place = truth[id].first;
      const Vec2 noise(0.0013 * random.normal(), 0.0013 * random.normal());
      const bool in_view = seen.camera == 0 ? place.x() <= 0.15 : place.x() >= -0.15;
      if (in_view) seen.robots.push_back({id, {place + shifts[seen.camera] + noise, 0.0}, 1.0});
    }
    model.add_frame(seen);
    for (const RobotState& robot : model.state().robots) {
      const Vec2 error = robot.pose.position_m - truth[robot.id].first;
      if (t > 4.0) {  // the first crossings teach
        const double wrong = (robot.twist.velocity_mps - truth[robot.id].second).norm();
        errors.fastest_wrong_mps = std::max(errors.fastest_wrong_mps, wrong);
        errors.jump_m = std::max(errors.jump_m, (error - last_error[robot.id]).norm());
      }
      last_error[robot.id] = error;
    }
  }
  return errors;
}

TEST_CASE("robots do not jump from camera to camera: what is left is what cameras that agree would show") {
  double learnt_jumps_m = 0.0;
  double unlearnt_jumps_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    const Errors learnt = driven(true, 0.014, seed);
    const Errors agreeing = driven(false, 0.0, seed);
    CHECK(learnt.fastest_wrong_mps < 1.1 * agreeing.fastest_wrong_mps);
    CHECK(learnt.jump_m < 1.1 * agreeing.jump_m);
    learnt_jumps_m += learnt.jump_m;
    unlearnt_jumps_m += driven(false, 0.014, seed).jump_m;
  }
  CHECK(unlearnt_jumps_m > 1.5 * learnt_jumps_m);
}

TEST_CASE("what is learnt of cameras is forgotten with a source that begins anew") {
  WorldModel model;
  const auto look = [&](std::uint32_t camera, double t, std::uint32_t number, const Vec2& place) {
    VisionFrame frame;
    frame.camera = camera;
    frame.captured = Time{} + from_seconds(t);
    frame.frame_number = number;
    frame.robots = {{{Team::blue, 1}, {place, 0.0}, 1.0}};
    return model.add_frame(frame);
  };
  for (std::uint32_t i = 0; i < 200; ++i) {
    look(0, 100.0 + 0.01 * i, i, {1.0, 0.0});
    look(1, 100.005 + 0.01 * i, i, {1.02, 0.0});
  }
  CHECK(model.state().robots.at(0).pose.position_m.x() == Approx(1.01).margin(0.001));
  bool restarted = false;
  for (std::uint32_t i = 0; i < 10; ++i) {
    restarted = look(1, 1.0 + 0.01 * i, i, {2.0, 0.0}) == FrameResult::restarted || restarted;
  }
  CHECK(restarted);
  CHECK(model.state().robots.at(0).pose.position_m.x() == Approx(2.0).margin(1e-6));
}

}  // namespace
}  // namespace regista
