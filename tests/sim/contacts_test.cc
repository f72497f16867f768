#include "sim/contacts.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/random.h"

namespace regista {
namespace {

constexpr double kRadius_m = 0.09;
constexpr RobotId kYellow{Team::yellow, 3};
constexpr RobotId kBlue{Team::blue, 1};

RobotBody body(RobotId id, const Vec2& position_m, const Vec2& velocity_mps) {
  return {id, {position_m, 0.0}, {velocity_mps, 0.0}};
}

std::vector<Vec2> places(const std::vector<RobotBody>& robots) {
  std::vector<Vec2> out;
  for (const RobotBody& robot : robots) out.push_back(robot.pose.position_m);
  return out;
}

// Each moment by itself: nobody moves in its step.
ContactLog observed(const std::vector<std::vector<RobotBody>>& moments) {
  ContactLog log(kRadius_m);
  NearPairs near;
  Time now{};
  for (const auto& robots : moments)
    log.observe(robots, places(robots), near.find(robots, log.end_distance_m()), now += Duration{1000});
  return log;
}

// Yellow at the left, blue 0.17 m to its right, with these speeds along x.
Contact crash(double yellow_mps, double blue_mps) {
  const ContactLog log = observed({{body(kYellow, {0, 0}, {yellow_mps, 0}), body(kBlue, {0.17, 0}, {blue_mps, 0})}});
  REQUIRE(log.contacts().size() == 1);
  return log.contacts().front();
}

TEST_CASE("the crash rule") {
  CHECK(crash(1.0, -1.0).fault == Fault::both);  // head on
  CHECK(crash(1.0, -1.0).closing_speed_mps == Approx(2.0));
  CHECK(crash(1.2, -0.91).fault == Fault::both);   // differ by 0.29
  CHECK(crash(1.2, -0.89).fault == Fault::first);  // differ by 0.31
  CHECK(crash(0.5, -2.0).fault == Fault::second);
  CHECK(crash(3.0, 1.0).fault == Fault::first);     // from behind
  CHECK(crash(-1.0, -3.0).fault == Fault::second);  // from behind, the other way
  CHECK(crash(2.0, 0.0).fault == Fault::first);     // into one that stands
  CHECK(crash(0.7, -0.7).fault == Fault::none);     // slow
  CHECK(crash(1.5, 0.0).fault == Fault::none);      // exactly at the limit
  CHECK(crash(-1.0, 1.0).fault == Fault::none);     // going apart
  CHECK(crash(-1.0, 1.0).closing_speed_mps == Approx(-2.0));
}

TEST_CASE("only the speed along the line of centres counts") {
  const RobotBody yellow = body(kYellow, {0, 0}, {0.0, 3.0});
  const RobotBody blue = body(kBlue, {0.17, 0}, {-1.4, -3.0});
  CHECK(closing_speed_mps(yellow, blue) == Approx(1.4));
  CHECK(crash_fault(yellow, blue) == Fault::none);
}

TEST_CASE("judgement is the same in a turned or mirrored world, and does not depend on who is named first") {
  Random random(7);
  const auto vector = [&random](double size) {
    const double x = random.uniform(-size, size);
    return Vec2(x, random.uniform(-size, size));
  };
  const auto swapped = [](Fault fault) {
    return fault == Fault::first ? Fault::second : fault == Fault::second ? Fault::first : fault;
  };
  int guilty = 0;
  for (int i = 0; i < 2000; ++i) {
    const RobotBody a = body(kYellow, vector(4), vector(3));
    const RobotBody b = body(kBlue, a.pose.position_m + vector(0.12), vector(3));
    const double angle = random.uniform(-3.0, 3.0);
    const auto turned = [angle](RobotBody robot) {
      robot.pose.position_m = rotated(robot.pose.position_m, angle);
      robot.twist.velocity_mps = rotated(robot.twist.velocity_mps, angle);
      return robot;
    };
    const auto mirrored = [](RobotBody robot) {
      robot.pose.position_m.y() *= -1.0;
      robot.twist.velocity_mps.y() *= -1.0;
      return robot;
    };
    const Fault fault = crash_fault(a, b);
    guilty += fault != Fault::none;
    CHECK(crash_fault(b, a) == swapped(fault));
    CHECK(crash_fault(turned(a), turned(b)) == fault);
    CHECK(crash_fault(mirrored(a), mirrored(b)) == fault);
  }
  CHECK(guilty > 200);
}

TEST_CASE("how far a speed is beyond a foul is positive exactly where it is one, and goes down with it") {
  std::mt19937_64 random(12);
  for (int i = 0; i < 2000; ++i) {
    const double first = uniform(random, -3.0, 3.0);
    const double second = uniform(random, -3.0, 3.0);
    const Fault fault = crash_fault(first, second);
    INFO(first << " and " << second << " m/s towards each other");
    CHECK((foul_excess(first, second) > 0.0) == (fault == Fault::first || fault == Fault::both));
    CHECK(foul_excess(first - 0.1, second) == Approx(foul_excess(first, second) - 0.1));
  }
}

TEST_CASE("a contact begins below two radii and ends 1 cm above") {
  const auto at = [](double distance_m) {
    return std::vector<RobotBody>{body(kYellow, {0, 0}, {0, 0}), body(kBlue, {0, distance_m}, {0, 0})};
  };
  CHECK(observed({at(0.181)}).contacts().empty());
  CHECK(observed({at(0.179)}).contacts().size() == 1);
  CHECK(observed({at(0.179), at(0.189), at(0.179)}).contacts().size() == 1);
  const ContactLog twice = observed({at(0.179), at(0.191), at(0.185), at(0.179)});
  REQUIRE(twice.contacts().size() == 2);
  CHECK(twice.contacts()[0].at == Time{Duration{1000}});
  CHECK(twice.contacts()[1].at == Time{Duration{4000}});
}

// One step of 1 ms in which both go from `before` straight to where they are.
ContactLog stepped(const std::vector<Vec2>& before_m, const std::vector<RobotBody>& after) {
  ContactLog log(kRadius_m);
  log.observe(after, before_m, {{0, 1}}, Time{Duration{1000}});
  return log;
}

TEST_CASE("who touches in the middle of a step has touched, and is judged by that moment") {
  // Yellow shoots past blue, 0.1 m beside its centre, by 1 m in the step.
  const RobotBody yellow = body(kYellow, {0.5, 0.1}, {1000.0, 0.0});
  const RobotBody blue = body(kBlue, {0.0, 0.0}, {0.0, 0.0});
  const ContactLog log = stepped({{-0.5, 0.1}, {0.0, 0.0}}, {yellow, blue});
  REQUIRE(log.contacts().size() == 1);
  CHECK(log.contacts()[0].fault == Fault::first);
  CHECK(log.contacts()[0].closing_speed_mps == Approx(1000.0 * std::sqrt(0.18 * 0.18 - 0.1 * 0.1) / 0.18));
  // The contact is over: they are far apart at the end, so the next one is a new one.
  CHECK(stepped({{-0.5, 0.19}, {0.0, 0.0}}, {body(kYellow, {0.5, 0.19}, {1000.0, 0.0}), blue}).contacts().empty());
  CHECK(stepped({{0.2, 0.0}, {0.0, 0.0}}, {body(kYellow, {1.0, 0.0}, {800.0, 0.0}), blue}).contacts().empty());
}

TEST_CASE("a step's contacts are those of the same step sampled densely") {
  Random random(17);
  const auto vector = [&random](double size) {
    const double x = random.uniform(-size, size);
    return Vec2(x, random.uniform(-size, size));
  };
  int touched = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 a_before = vector(0.3), b_before = vector(0.3);
    const RobotBody a = body(kYellow, a_before + vector(0.5), {0, 0});
    const RobotBody b = body(kBlue, b_before + vector(0.5), {0, 0});
    double least_m = 1.0;
    for (int k = 0; k <= 1000; ++k) {
      const double s = k / 1000.0;
      const Vec2 apart = (1.0 - s) * (b_before - a_before) + s * (b.pose.position_m - a.pose.position_m);
      least_m = std::min(least_m, apart.norm());
    }
    if (std::abs(least_m - 0.18) < 1e-4) continue;  // too near to tell by sampling
    INFO("case " << i << ", least distance " << least_m);
    REQUIRE(stepped({a_before, b_before}, {a, b}).contacts().size() == (least_m < 0.18 ? 1 : 0));
    touched += least_m < 0.18;
  }
  CHECK(touched > 500);
}

TEST_CASE("contacts are counted by team, fault only between opponents") {
  const RobotBody y0 = body({Team::yellow, 0}, {0.0, 0}, {3, 0});
  const RobotBody y1 = body({Team::yellow, 1}, {0.17, 0}, {0, 0});
  const RobotBody b0 = body({Team::blue, 0}, {0.34, 0}, {-3, 0});
  const RobotBody b1 = body({Team::blue, 1}, {0.51, 0}, {0, 0});
  const ContactLog log = observed({{y0, y1, b0, b1}});
  CHECK(log.counts() == ContactCounts{1, 1, 1, 0, 1});
  REQUIRE(log.contacts().size() == 3);
  CHECK(log.contacts()[0].fault == Fault::none);  // Y0 into Y1 at 3 m/s is no foul
  CHECK(log.contacts()[1].first == y1.id);
  CHECK(log.contacts()[1].second == b0.id);
}

TEST_CASE("a long run's log keeps the newest contacts and counts all") {
  std::vector<std::vector<RobotBody>> moments;
  for (std::size_t i = 0; i < kContactsKept + 7; ++i) {
    for (const double distance_m : {0.17, 0.3}) {
      moments.push_back({body(kYellow, {0, 0}, {0, 0}), body(kBlue, {distance_m, 0}, {0, 0})});
    }
  }
  const ContactLog log = observed(moments);
  CHECK(log.counts().opponent == static_cast<std::int64_t>(kContactsKept) + 7);
  REQUIRE(log.contacts().size() == kContactsKept);
  CHECK(log.contacts().front().at == from_us(1000 * (2 * 7 + 1)));
  CHECK(log.contacts().back().at == from_us(1000 * (2 * (static_cast<std::int64_t>(kContactsKept) + 6) + 1)));
}

TEST_CASE("near pairs are those of the comparison of all with all") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    std::vector<RobotBody> robots;
    for (std::uint16_t i = 0; i < 60; ++i) {
      const double x = random.uniform(-1, 1);
      robots.push_back(body({Team::yellow, i}, {x, random.uniform(-1, 1)}, {0, 0}));
    }
    NearPairs near;
    for (int moment = 0; moment < 5; ++moment) {
      std::vector<IndexPair> expected;
      for (std::uint32_t i = 0; i < robots.size(); ++i) {
        for (std::uint32_t j = i + 1; j < robots.size(); ++j) {
          const double distance = (robots[i].pose.position_m - robots[j].pose.position_m).norm();
          if (distance <= 0.19) expected.push_back({i, j});
        }
      }
      REQUIRE_FALSE(expected.empty());
      REQUIRE(near.find(robots, 0.19) == expected);
      for (RobotBody& robot : robots) robot.pose.position_m.x() += random.uniform(-0.5, 0.5);
    }
  }
}

TEST_CASE("bodies are parted, each by half, and go on with their mean speed along the line of centres") {
  std::vector<RobotBody> robots{body(kYellow, {0, 0}, {2, 1}), body(kBlue, {0.16, 0}, {-1, 0})};
  keep_apart(robots, {{0, 1}}, RobotLimits{});
  CHECK(robots[0].pose.position_m.x() == Approx(-0.01));
  CHECK(robots[1].pose.position_m.x() == Approx(0.17));
  CHECK(robots[0].twist.velocity_mps.isApprox(Vec2(0.5, 1.0)));
  CHECK(robots[1].twist.velocity_mps.isApprox(Vec2(0.5, 0.0)));

  // Going apart already: only the places change. One on the other: parted somehow.
  robots = {body(kYellow, {1, 1}, {-2, 0}), body(kBlue, {1, 1}, {1, 0})};
  keep_apart(robots, {{0, 1}}, RobotLimits{});
  CHECK((robots[0].pose.position_m - robots[1].pose.position_m).norm() == Approx(0.18));
  CHECK(robots[0].twist.velocity_mps == Vec2(-2.0, 0.0));
}

TEST_CASE("a heap of overlapping robots comes apart") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    std::vector<RobotBody> robots;
    for (std::uint16_t i = 0; i < 22; ++i) {
      const double x = random.uniform(-0.3, 0.3);
      robots.push_back(body({Team::yellow, i}, {x, random.uniform(-0.3, 0.3)}, {0, 0}));
    }
    NearPairs near;
    for (int i = 0; i < 500; ++i) keep_apart(robots, near.find(robots, 0.19), RobotLimits{});
    for (const IndexPair& pair : near.find(robots, 0.19)) {
      const Vec2 off = robots[pair.first].pose.position_m - robots[pair.second].pose.position_m;
      CHECK(off.norm() >= 0.18 - 1e-3);
    }
  }
}

}  // namespace
}  // namespace regista
