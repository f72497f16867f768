// Robot and ball filter on their own: what they recover, reject and know from commands.
#include <catch2/catch.hpp>

#include "tests/world_model/scene.h"
#include "world_model/prediction.h"

namespace regista {
namespace {

using test::at_ms;

TEST_CASE("noiseless constant velocity is recovered exactly, across the wrap of the heading") {
  std::mt19937_64 random(6);
  const RobotFilterParams params;
  for (int run = 0; run < 20; ++run) {
    CAPTURE(run);
    const Pose start{{test::uniform(random, -6, 6), test::uniform(random, -4, 4)}, test::uniform(random, -3, 3)};
    const Twist twist{{test::uniform(random, -3, 3), test::uniform(random, -3, 3)}, test::uniform(random, -10, 10)};
    RobotFilter filter(start, at_ms(0), params);
    for (int i = 1; i <= 300; ++i) {
      filter.advance(at_ms(10.0 * i), {}, params);
      const Pose seen = test::moved(start, twist, 0.01 * i);
      REQUIRE(filter.accepts(seen, at_ms(10.0 * i), params));
      filter.correct(seen, at_ms(10.0 * i), params);
      REQUIRE(std::abs(filter.heading().value) <= std::numbers::pi);
    }
    const RobotState state = filter.state(test::kY3, {});
    const Pose truth = test::moved(start, twist, 3.0);
    CHECK((state.pose.position_m - truth.position_m).norm() < 1e-9);
    CHECK(std::abs(wrap_angle(state.pose.heading_rad - truth.heading_rad)) < 1e-9);
    CHECK((state.twist.velocity_mps - twist.velocity_mps).norm() < 1e-8);
    CHECK(state.twist.angular_radps == Approx(twist.angular_radps).margin(1e-8));
  }
}

TEST_CASE("a detection older than the estimate corrects it as of its own time") {
  const RobotFilterParams params;
  const Twist twist{{2.0, -1.0}, 3.0};
  RobotFilter filter({}, at_ms(0), params);
  for (int i = 1; i <= 200; ++i) {
    filter.advance(at_ms(10.0 * i), {}, params);
    filter.correct(test::moved({}, twist, 0.01 * i), at_ms(10.0 * i), params);
    filter.correct(test::moved({}, twist, 0.01 * i - 0.007), at_ms(10.0 * i - 7.0), params);
  }
  CHECK(filter.time() == at_ms(2000));
  CHECK((filter.state({}, {}).pose.position_m - Vec2(4.0, -2.0)).norm() < 1e-9);
  CHECK((filter.state({}, {}).twist.velocity_mps - twist.velocity_mps).norm() < 1e-8);
}

TEST_CASE("stated variances match the errors made") {
  std::mt19937_64 random(7);
  RobotFilterParams params;
  params.position_sigma_m = 0.0013;
  double position = 0.0;
  double velocity = 0.0;
  int count = 0;
  for (int run = 0; run < 200; ++run) {
    Vec2 p = Vec2::Zero();
    Vec2 v = Vec2::Zero();
    RobotFilter filter({}, at_ms(0), params);
    for (int i = 1; i <= 100; ++i) {
      // White acceleration over 10 ms, as the filter assumes it.
      const Vec2 dv =
          Vec2(test::normal(random), test::normal(random)) * std::sqrt(params.acceleration_density_m2ps3 * 0.01);
      p += v * 0.01 + dv * 0.005;
      v += dv;
      filter.advance(at_ms(10.0 * i), {}, params);
      const Vec2 noise = Vec2(test::normal(random), test::normal(random)) * params.position_sigma_m;
      filter.correct({p + noise, 0.0}, at_ms(10.0 * i), params);
      if (i < 20) continue;
      const RobotState state = filter.state({}, {});
      position += (state.pose.position_m - p).squaredNorm() / 2.0 / state.position_variance_m2;
      velocity += (state.twist.velocity_mps - v).squaredNorm() / 2.0 / state.velocity_variance_m2ps2;
      ++count;
    }
  }
  CHECK(position / count == Approx(1.0).margin(0.1));
  CHECK(velocity / count == Approx(1.0).margin(0.1));
}

/// Root mean square of the velocity error of a robot that follows its commands with 30 ms latency and 30 ms lag.
double velocity_error(bool use_commands, double follows) {
  std::mt19937_64 random(8);
  RobotFilterParams params;
  params.position_sigma_m = 0.0013;
  params.heading_sigma_rad = 0.01;
  const Duration latency{30000};
  RobotState truth;
  RobotFilter filter({}, at_ms(0), params);
  std::vector<SentVelocity> told;
  std::vector<SentVelocity> done;  // what the robot makes of it
  double sum = 0.0;
  for (int i = 0; i < 600; ++i) {
    const Time now = at_ms(10.0 * i);
    const double phase = 0.01 * i;
    const BodyVelocity u{1.5 * std::sin(4.0 * phase), std::cos(3.0 * phase), 4.0 * std::sin(2.0 * phase)};
    told.push_back({now, u});
    done.push_back({now, {follows * u.forward_mps, follows * u.left_mps, follows * u.angular_radps}});
    const Time next = at_ms(10.0 * (i + 1));
    truth = predicted(truth, now, next, done, latency, 0.03);
    filter.advance(next, use_commands ? CommandModel{told, latency, 0.03} : CommandModel{}, params);
    const Vec2 noise = Vec2(test::normal(random), test::normal(random)) * params.position_sigma_m;
    filter.correct({truth.pose.position_m + noise, wrap_angle(truth.pose.heading_rad + 0.01 * test::normal(random))},
                   next, params);
    if (i > 50) sum += (filter.state({}, {}).twist.velocity_mps - truth.twist.velocity_mps).squaredNorm();
  }
  return std::sqrt(sum / 549.0);
}

TEST_CASE("commands make the velocity better known, and a robot that obeys badly does not mislead") {
  const double with = velocity_error(true, 1.0);
  const double without = velocity_error(false, 1.0);
  INFO("velocity error in m/s: with commands " << with << ", without " << without);
  CHECK(with < 0.5 * without);
  CHECK(velocity_error(true, 0.8) < without);
}

TEST_CASE("a blocked robot is seen to stand whatever it was told") {
  RobotFilterParams params;
  RobotFilter filter({}, at_ms(0), params);
  std::vector<SentVelocity> told;
  for (int i = 0; i < 100; ++i) {
    told.push_back({at_ms(10.0 * i), {2.0, 0.0, 0.0}});
    filter.advance(at_ms(10.0 * (i + 1)), {told, Duration{0}, 0.0}, params);
    filter.correct({}, at_ms(10.0 * (i + 1)), params);
  }
  CHECK(filter.state({}, {}).twist.velocity_mps.norm() < 0.01);
  CHECK(filter.state({}, {}).pose.position_m.norm() < 1e-3);
}

TEST_CASE("the ball filter follows rolling and kicks, and ends at rest") {
  std::mt19937_64 random(9);
  const BallFilterParams params;
  BallState truth;
  BallFilter filter({0.0, 0.0}, at_ms(0), params);
  for (int i = 1; i <= 800; ++i) {
    if (i == 100) truth.velocity_mps = {1.6, -1.2};  // kicked
    truth = predicted(truth, Duration{10000}, params.rolling_deceleration_mps2);
    filter.advance(at_ms(10.0 * i), params);
    const Vec2 seen = truth.position_m + Vec2(test::normal(random), test::normal(random)) * params.position_sigma_m;
    REQUIRE(filter.accepts(seen, at_ms(10.0 * i), params));
    filter.correct(seen, at_ms(10.0 * i), params);
    const double error = (filter.state({}).velocity_mps - truth.velocity_mps).norm();
    CAPTURE(i);
    if (i == 105) CHECK(error < 0.5);
    if (i > 130) CHECK(error < 0.2);
  }
  CHECK(truth.velocity_mps.norm() == 0.0);
  CHECK(filter.state({}).velocity_mps.norm() < 0.1);
  CHECK((filter.state({}).position_m - truth.position_m).norm() < 0.003);
}

TEST_CASE("a kick is known two frames after it shows") {
  const BallFilterParams params;
  for (const double speed_mps : {4.0, 6.5}) {
    CAPTURE(speed_mps);
    BallFilter filter({0.0, 0.0}, at_ms(0), params);
    for (int i = 1; i <= 103; ++i) {
      filter.advance(at_ms(10.0 * i), params);
      const Vec2 seen(i <= 100 ? 0.0 : speed_mps * 0.01 * (i - 100), 0.0);
      REQUIRE(filter.accepts(seen, at_ms(10.0 * i), params));
      filter.correct(seen, at_ms(10.0 * i), params);
    }
    CHECK((filter.state({}).velocity_mps - Vec2(speed_mps, 0.0)).norm() < 0.1 * speed_mps);
  }
}

TEST_CASE("noiseless rolling is recovered exactly") {
  const BallFilterParams params;
  BallState truth;
  truth.velocity_mps = {-2.0, 1.0};
  BallFilter filter({0.0, 0.0}, at_ms(0), params);
  for (int i = 1; i <= 300; ++i) {
    truth = predicted(truth, Duration{10000}, params.rolling_deceleration_mps2);
    filter.advance(at_ms(10.0 * i), params);
    filter.correct(truth.position_m, at_ms(10.0 * i), params);
  }
  CHECK((filter.state({}).position_m - truth.position_m).norm() < 1e-7);
  CHECK((filter.state({}).velocity_mps - truth.velocity_mps).norm() < 1e-6);
}

}  // namespace
}  // namespace regista
