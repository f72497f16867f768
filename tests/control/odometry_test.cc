// Wheel speeds integrated over a drive give the pose back, and what one wheel or all of them get wrong is averaged as
// least squares should.
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "control/wheels.h"
#include "sim/random.h"
#include "sim/robot_model.h"
#include "world_model/prediction.h"

namespace regista {
namespace {

/// One step of odometry: exact along the arc of a constant body velocity.
Pose advanced(const Pose& pose, const BodyVelocity& velocity, Duration dt) {
  RobotState state;
  state.pose = pose;
  const SentVelocity sent{Time{}, velocity};
  return predicted(state, Time{}, Time{dt}, {&sent, 1}, Duration{0}, 0.0).pose;
}

BodyVelocity drawn(Random& random) {
  const double forward = random.uniform(-2.0, 2.0);
  const double left = random.uniform(-2.0, 2.0);
  return {forward, left, random.uniform(-6.0, 6.0)};
}

/// How each wheel answers to the body's three motions, from the public functions alone.
Eigen::Matrix<double, 4, 3> to_wheels(const OmniWheels& wheels) {
  Eigen::Matrix<double, 4, 3> matrix;
  const std::array<BodyVelocity, 3> units{BodyVelocity{1, 0, 0}, BodyVelocity{0, 1, 0}, BodyVelocity{0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const WheelSpeeds speeds = wheels.speeds(units[static_cast<std::size_t>(j)]);
    for (int i = 0; i < 4; ++i) matrix(i, j) = speeds[static_cast<std::size_t>(i)];
  }
  return matrix;
}

Eigen::Vector3d vector(const BodyVelocity& v) { return {v.forward_mps, v.left_mps, v.angular_radps}; }

WheelGeometry uneven() {
  WheelGeometry geometry;
  geometry.bearings_rad = "0.9,2.5,-2.2,-1.1";
  return geometry;
}

TEST_CASE("exact motion in arcs comes back exactly") {
  for (const WheelGeometry& geometry : {WheelGeometry{}, uneven()}) {
    const OmniWheels wheels(geometry);
    Random random(31);
    Pose truth, odometry;
    for (int i = 0; i < 2000; ++i) {
      const BodyVelocity v = drawn(random);
      truth = advanced(truth, v, Duration{10'000});
      odometry = advanced(odometry, wheels.velocity(wheels.speeds(v)), Duration{10'000});
    }
    CHECK((truth.position_m - odometry.position_m).norm() < 1e-9);
    CHECK(std::abs(wrap_angle(truth.heading_rad - odometry.heading_rad)) < 1e-9);
  }
}

TEST_CASE("a simulated drive comes back to a millimetre in ten seconds") {
  const OmniWheels wheels{WheelGeometry{}};
  Random random(32);
  RobotBody body;
  Pose odometry;
  BodyVelocity command;
  double driven_m = 0.0;
  for (int ms = 0; ms < 10'000; ++ms) {
    if (ms % 300 == 0) command = drawn(random);
    const RobotBody before = body;
    step(body, command, {}, 0.03, 0.001);
    // What encoders count over the step: the mean velocity in the mean heading.
    const Twist mean{(before.twist.velocity_mps + body.twist.velocity_mps) / 2.0,
                     (before.twist.angular_radps + body.twist.angular_radps) / 2.0};
    const double heading_rad = before.pose.heading_rad + mean.angular_radps * 0.0005;
    odometry = advanced(odometry, wheels.velocity(wheels.speeds(to_body(mean, heading_rad))), Duration{1000});
    driven_m += (body.pose.position_m - before.pose.position_m).norm();
  }
  CHECK(driven_m > 8.0);
  CHECK((body.pose.position_m - odometry.position_m).norm() < 0.001);
  CHECK(std::abs(wrap_angle(body.pose.heading_rad - odometry.heading_rad)) < 0.001);
}

TEST_CASE("one slipping wheel: its error comes through by its share, and less than without least squares") {
  for (const WheelGeometry& geometry : {WheelGeometry{}, uneven()}) {
    const OmniWheels wheels(geometry);
    const Eigen::Matrix<double, 4, 3> matrix = to_wheels(wheels);
    Random random(33);
    for (int i = 0; i < 400; ++i) {
      const BodyVelocity v = drawn(random);
      WheelSpeeds measured = wheels.speeds(v);
      const std::size_t slips = static_cast<std::size_t>(i) % 4;
      const double error = random.uniform(-0.3, 0.3) * measured[slips];
      measured[slips] += error;
      const Eigen::Vector3d wrong = vector(wheels.velocity(measured)) - vector(v);
      const Eigen::Vector4d unit = Eigen::Vector4d::Unit(static_cast<Eigen::Index>(slips));
      const Eigen::Vector3d share = (matrix.transpose() * matrix).inverse() * matrix.transpose() * unit;
      CHECK((wrong - error * share).norm() < 1e-9);
      // Its part in how the wheels fit together is at most the whole of its error.
      CHECK((matrix * wrong).norm() <= std::abs(error) + 1e-9);
      // Three wheels are enough for a velocity, but any three with the slipping one are misled more.
      for (int left_out = 0; left_out < 4; ++left_out) {
        if (static_cast<std::size_t>(left_out) == slips) continue;
        Eigen::Matrix3d three;
        Eigen::Vector3d of_three;
        for (int row = 0, from = 0; from < 4; ++from) {
          if (from == left_out) continue;
          three.row(row) = matrix.row(from);
          of_three[row++] = from == static_cast<int>(slips) ? error : 0.0;
        }
        CHECK((matrix * (three.inverse() * of_three)).norm() >= (matrix * wrong).norm() - 1e-9);
      }
    }
  }
}

TEST_CASE("noise of all wheels: the velocity scatters as (JᵀJ)⁻¹ says, the pose of a drive as its sum") {
  constexpr double kSigma_radps = 2.0;
  constexpr int kDrives = 4000;
  constexpr int kSteps = 50;
  const OmniWheels wheels{WheelGeometry{}};
  const Eigen::Matrix<double, 4, 3> matrix = to_wheels(wheels);
  const Eigen::Matrix3d expected = kSigma_radps * kSigma_radps * (matrix.transpose() * matrix).inverse();
  Random random(34);
  Eigen::Matrix3d velocity = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pose = Eigen::Vector3d::Zero();
  const BodyVelocity forward{1.0, 0.0, 0.0};
  for (int drive = 0; drive < kDrives; ++drive) {
    Pose odometry;
    for (int i = 0; i < kSteps; ++i) {
      WheelSpeeds measured = wheels.speeds(forward);
      for (double& speed : measured) speed += kSigma_radps * random.normal();
      const BodyVelocity seen = wheels.velocity(measured);
      const Eigen::Vector3d error = vector(seen) - vector(forward);
      velocity += error * error.transpose() / (kDrives * kSteps);
      odometry = advanced(odometry, seen, Duration{1000});
    }
    const Vec2 off = odometry.position_m - Vec2(0.001 * kSteps, 0.0);
    pose +=
        Eigen::Vector3d(off.x() * off.x(), off.y() * off.y(), odometry.heading_rad * odometry.heading_rad) / kDrives;
  }
  const double size = expected.norm();
  CHECK((velocity - expected).norm() < 0.02 * size);
  // 50 independent steps of 1 ms; the drive is so short that headings do not bend it. Six standard errors, √(2/4000).
  for (const int axis : {0, 1, 2}) {
    const double variance = expected(axis, axis) * 1e-6 * kSteps;
    CHECK(pose[axis] == Approx(variance).epsilon(0.13));
  }
}

}  // namespace
}  // namespace regista
