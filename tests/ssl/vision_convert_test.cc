#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <limits>

#include "modules/convert/vision.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_vision_convert.h"
#include "ssl_vision_wrapper.pb.h"
#include "tests/ssl/packets.h"
#include "tests/ssl/protoc.h"
#include "tests/ssl/wire.h"

using namespace regista;

namespace {

ConvertedFrame convert(const std::string& bytes) {
  return to_vision_frame(parse_packet<SSL_WrapperPacket>(as_bytes(bytes)).detection());
}

SSL_DetectionRobot detected(float x_mm, float y_mm) {
  SSL_DetectionRobot robot;
  robot.set_confidence(1);
  robot.set_robot_id(7);
  robot.set_x(x_mm);
  robot.set_y(y_mm);
  robot.set_orientation(0);
  robot.set_pixel_x(0);
  robot.set_pixel_y(0);
  return robot;
}

SSL_DetectionFrame frame_with(const SSL_DetectionRobot& robot) {
  SSL_DetectionFrame frame;
  *frame.add_robots_blue() = robot;
  return frame;
}

}  // namespace

TEST_CASE("a detection frame in metres, with the source's own stamps") {
  const ConvertedFrame out = convert(encode_vision(detection_text(2, 41)));
  VisionFrame wanted;
  wanted.captured = from_us(1'700'000'000'250'000);
  wanted.sent = from_us(1'700'000'000'300'000);
  wanted.camera = 2;
  wanted.frame_number = 41;
  wanted.robots = {{{Team::yellow, 3}, {{1.0, -2.0}, 1.5}, 0.5}, {{Team::blue, 12}, {{-5.999, 4.499}, -3.0}, 1.0}};
  wanted.balls = {{{-1.5, 2.2505}, 0.75}};
  CHECK(out.frame == wanted);
  CHECK(out.robots_skipped == 0);
}

TEST_CASE("the league's field numbers, written by hand") {
  const std::string ball = wire::of_float(1, 0.5F) + wire::of_int(2, 60) + wire::of_float(3, -250.0F) +
                           wire::of_float(4, 500.0F) + wire::of_float(5, 0.0F) + wire::of_float(6, 1.0F) +
                           wire::of_float(7, 1.0F);
  const std::string robot = wire::of_float(1, 1.0F) + wire::of_int(2, 15) + wire::of_float(3, 100.0F) +
                            wire::of_float(4, -100.0F) + wire::of_float(5, 0.25F) + wire::of_float(6, 1.0F) +
                            wire::of_float(7, 1.0F) + wire::of_float(8, 140.0F);
  const std::string frame = wire::of_int(1, 9) + wire::of_double(2, 12.5) + wire::of_double(3, 12.75) +
                            wire::of_int(4, 3) + wire::of_bytes(5, ball) + wire::of_bytes(6, robot) +
                            wire::of_bytes(7, robot) + wire::of_double(8, 1.0);
  const ConvertedFrame out = convert(wire::of_bytes(1, frame) + wire::of_int(3, 4));
  VisionFrame wanted{from_us(12'500'000), from_us(12'750'000), 3, 9, {}, {}};
  wanted.robots = {{{Team::yellow, 15}, {{0.1, -0.1}, 0.25}, 1.0}, {{Team::blue, 15}, {{0.1, -0.1}, 0.25}, 1.0}};
  wanted.balls = {{{-0.25, 0.5}, 0.5}};
  CHECK(out.frame == wanted);
}

TEST_CASE("robots without number or heading are left out and counted") {
  SSL_DetectionFrame frame;
  *frame.add_robots_yellow() = detected(0, 0);
  *frame.add_robots_yellow() = detected(1000, 0);
  frame.mutable_robots_yellow(1)->clear_robot_id();
  *frame.add_robots_blue() = detected(2000, 0);
  frame.mutable_robots_blue(0)->clear_orientation();
  *frame.add_robots_blue() = detected(3000, 0);
  frame.mutable_robots_blue(1)->set_robot_id(65536);
  const ConvertedFrame out = to_vision_frame(frame);
  CHECK(out.robots_skipped == 3);
  REQUIRE(out.frame.robots.size() == 1);
  CHECK(out.frame.robots[0].id == RobotId{Team::yellow, 7});
}

TEST_CASE("a confidence beyond 0–1 is clamped") {
  SSL_DetectionRobot robot = detected(0, 0);
  robot.set_confidence(100);
  CHECK(to_vision_frame(frame_with(robot)).frame.robots.at(0).confidence == 1.0);
  robot.set_confidence(-1);
  CHECK(to_vision_frame(frame_with(robot)).frame.robots.at(0).confidence == 0.0);
}

TEST_CASE("values that are no robot's refuse the frame") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinity, -infinity, 1.1e7F, -1.1e7F}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(to_vision_frame(frame_with(detected(bad, 0))), MessageError);
    CHECK_THROWS_AS(to_vision_frame(frame_with(detected(0, bad))), MessageError);
    SSL_DetectionFrame with_ball;
    with_ball.add_balls()->set_x(bad);
    CHECK_THROWS_AS(to_vision_frame(with_ball), MessageError);
  }
  SSL_DetectionRobot robot = detected(0, 0);
  robot.set_orientation(nan);
  CHECK_THROWS_AS(to_vision_frame(frame_with(robot)), MessageError);
  robot = detected(0, 0);
  robot.set_confidence(nan);
  CHECK_THROWS_AS(to_vision_frame(frame_with(robot)), MessageError);
  robot = detected(nan, 0);
  robot.clear_robot_id();
  CHECK_THROWS_AS(to_vision_frame(frame_with(robot)), MessageError);
}

TEST_CASE("stamps that no clock shows refuse the frame, far futures do not") {
  SSL_DetectionFrame frame;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e12}) {
    CAPTURE(bad);
    frame.set_t_capture(bad);
    CHECK_THROWS_AS(to_vision_frame(frame), MessageError);
  }
  frame.set_t_capture(1e10);
  CHECK(to_vision_frame(frame).frame.captured == from_us(10'000'000'000'000'000));
}

TEST_CASE("every position in range comes out divided by a thousand, every frame passes the bus") {
  const bool ok = rc::check([] {
    const int x_mm = *rc::gen::inRange(-1'000'000, 1'000'001);
    const int y_mm = *rc::gen::inRange(-1'000'000, 1'000'001);
    const int heading_mrad = *rc::gen::inRange(-100'000, 100'000);
    SSL_DetectionRobot robot = detected(static_cast<float>(x_mm), static_cast<float>(y_mm));
    robot.set_orientation(static_cast<float>(heading_mrad) / 1000.0F);
    const VisionFrame frame = to_vision_frame(frame_with(robot)).frame;
    RC_ASSERT(frame.robots.size() == 1U);
    const Pose& pose = frame.robots[0].pose;
    RC_ASSERT(pose.position_m == Vec2(x_mm / 1000.0, y_mm / 1000.0));
    RC_ASSERT(std::abs(pose.heading_rad) <= std::numbers::pi);
    RC_ASSERT(std::abs(std::sin(pose.heading_rad) - std::sin(double{robot.orientation()})) < 1e-12);
    RC_ASSERT(decode<VisionFrame>(encode(frame)) == frame);
  });
  REQUIRE(ok);
}
