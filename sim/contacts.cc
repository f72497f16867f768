#include "sim/contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace regista {
namespace {

Vec2 line_of_centres(const RobotBody& from, const RobotBody& to) {
  const Vec2 off = to.pose.position_m - from.pose.position_m;
  const double distance = off.norm();
  return distance > 0.0 ? Vec2(off / distance) : Vec2(1.0, 0.0);
}

/// The part of the step, 0 to 1, after which two centres that go straight from `before` to `after` apart first come
/// closer than distance_m; nothing when they do not. |before + s (after − before)|² = distance², solved for the least
/// s.
std::optional<double> first_within(const Vec2& before, const Vec2& after, double distance_m) {
  const double c = before.squaredNorm() - distance_m * distance_m;
  if (c < 0.0) return 0.0;
  const Vec2 way = after - before;
  const double a = way.squaredNorm();
  const double b = before.dot(way);  // half the linear coefficient
  const double discriminant = b * b - a * c;
  if (b >= 0.0 || discriminant <= 0.0) return std::nullopt;  // going apart, passing by or grazing
  const double s = (-b - std::sqrt(discriminant)) / a;
  return s < 1.0 ? std::optional(s) : std::nullopt;
}

RobotBody moved_back(const RobotBody& robot, const Vec2& before_m, double part) {
  RobotBody moved = robot;
  moved.pose.position_m = before_m + part * (robot.pose.position_m - before_m);
  return moved;
}

}  // namespace

double closing_speed_mps(const RobotBody& a, const RobotBody& b) {
  return (a.twist.velocity_mps - b.twist.velocity_mps).dot(line_of_centres(a, b));
}

Fault crash_fault(const RobotBody& first, const RobotBody& second) {
  const Vec2 normal = line_of_centres(first, second);
  return crash_fault(first.twist.velocity_mps.dot(normal), -second.twist.velocity_mps.dot(normal));
}

ContactLog::ContactLog(double robot_radius_m) : robot_radius_m_(robot_radius_m) {}

void ContactLog::observe(const std::vector<RobotBody>& robots, std::span<const Vec2> before_m,
                         const std::vector<IndexPair>& near, Time now) {
  still_touching_.clear();
  for (const IndexPair& pair : near) {
    const RobotBody& a = robots[pair.first];
    const RobotBody& b = robots[pair.second];
    const Vec2 apart = b.pose.position_m - a.pose.position_m;
    bool touches = std::binary_search(touching_.begin(), touching_.end(), pair);
    if (!touches) {
      const Vec2& a_before = before_m[pair.first];
      const Vec2& b_before = before_m[pair.second];
      const auto part = first_within(b_before - a_before, apart, 2.0 * robot_radius_m_);
      touches = part.has_value();
      if (part) begin(moved_back(a, a_before, *part), moved_back(b, b_before, *part), now);
    }
    if (touches && apart.squaredNorm() <= end_distance_m() * end_distance_m()) still_touching_.push_back(pair);
  }
  touching_.swap(still_touching_);
}

void ContactLog::begin(const RobotBody& a, const RobotBody& b, Time now) {
  const RobotBody& first = a.id < b.id ? a : b;
  const RobotBody& second = a.id < b.id ? b : a;
  Contact contact{now, first.id, second.id, closing_speed_mps(first, second), Fault::none};
  if (first.id.team == second.id.team) {
    ++(first.id.team == Team::yellow ? counts_.own_yellow : counts_.own_blue);
  } else {
    // Ids are sorted by team first: `first` is yellow, `second` blue.
    contact.fault = crash_fault(first, second);
    ++counts_.opponent;
    if (contact.fault == Fault::first || contact.fault == Fault::both) ++counts_.at_fault_yellow;
    if (contact.fault == Fault::second || contact.fault == Fault::both) ++counts_.at_fault_blue;
  }
  contacts_.push_back(contact);
  if (contacts_.size() > kContactsKept) contacts_.pop_front();
}

void keep_apart(std::vector<RobotBody>& robots, const std::vector<IndexPair>& near, const RobotLimits& limits) {
  for (const IndexPair& pair : near) {
    RobotBody& a = robots[pair.first];
    RobotBody& b = robots[pair.second];
    const double overlap = 2.0 * limits.radius_m - (a.pose.position_m - b.pose.position_m).norm();
    if (overlap <= 0.0) continue;
    const Vec2 normal = line_of_centres(a, b);
    a.pose.position_m -= overlap / 2.0 * normal;
    b.pose.position_m += overlap / 2.0 * normal;
    const double closing = (a.twist.velocity_mps - b.twist.velocity_mps).dot(normal);
    if (closing <= 0.0) continue;
    a.twist.velocity_mps = clamped_norm(a.twist.velocity_mps - closing / 2.0 * normal, limits.speed_max_mps);
    b.twist.velocity_mps = clamped_norm(b.twist.velocity_mps + closing / 2.0 * normal, limits.speed_max_mps);
  }
}

}  // namespace regista
