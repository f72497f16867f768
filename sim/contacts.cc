#include "sim/contacts.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

Vec2 line_of_centres(const RobotBody& from, const RobotBody& to) {
  const Vec2 off = to.pose.position_m - from.pose.position_m;
  const double distance = off.norm();
  return distance > 0.0 ? Vec2(off / distance) : Vec2(1.0, 0.0);
}

}  // namespace

double closing_speed_mps(const RobotBody& a, const RobotBody& b) {
  return (a.twist.velocity_mps - b.twist.velocity_mps).dot(line_of_centres(a, b));
}

Fault crash_fault(const RobotBody& first, const RobotBody& second) {
  const Vec2 normal = line_of_centres(first, second);
  const double first_towards = first.twist.velocity_mps.dot(normal);
  const double second_towards = -second.twist.velocity_mps.dot(normal);
  if (first_towards + second_towards <= kCrashSpeed_mps) return Fault::none;
  if (std::abs(first_towards - second_towards) < kCrashDifference_mps) return Fault::both;
  return first_towards > second_towards ? Fault::first : Fault::second;
}

ContactLog::ContactLog(double robot_radius_m) : robot_radius_m_(robot_radius_m) {}

void ContactLog::observe(const std::vector<RobotBody>& robots, const std::vector<IndexPair>& near, Time now) {
  const double begin_distance = 2.0 * robot_radius_m_;
  still_touching_.clear();
  for (const IndexPair& pair : near) {
    const RobotBody& a = robots[pair.first];
    const RobotBody& b = robots[pair.second];
    const double distance_squared = (a.pose.position_m - b.pose.position_m).squaredNorm();
    if (distance_squared > end_distance_m() * end_distance_m()) continue;
    const bool touched = std::binary_search(touching_.begin(), touching_.end(), pair);
    if (!touched && distance_squared >= begin_distance * begin_distance) continue;
    if (!touched) begin(a, b, now);
    still_touching_.push_back(pair);
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
