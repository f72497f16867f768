#include "sim/random_targets.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

// Draws until a place is found; with half of the field allowed, a thousand failures mean that it is full.
constexpr int kTries = 1000;

}  // namespace

bool is_target_place(const Vec2& point_m, const FieldGeometry& field, const RandomTargetsParams& params) {
  const double x = std::abs(point_m.x());
  const double y = std::abs(point_m.y());
  if (x > field.length_m / 2.0 - params.robot_radius_m || y > field.width_m / 2.0 - params.robot_radius_m) return false;
  const double grown = params.robot_radius_m + params.area_margin_m;
  return x < field.length_m / 2.0 - field.defence_depth_m - grown || y > field.defence_width_m / 2.0 + grown;
}

RandomTargets::RandomTargets(Team team, const FieldGeometry& field, const RandomTargetsParams& params,
                             std::uint64_t seed)
    : team_(team), field_(field), params_(params), random_(seed) {
  if (!(params.distance_min_m > 0.0 && params.distance_min_m <= field.length_m / 2.0)) {
    throw std::invalid_argument("targets at least " + std::to_string(params.distance_min_m) + " m away on a field of " +
                                std::to_string(field.length_m) + " m");
  }
  if (!(params.arrival_m > 0.0 && params.arrival_m < params.distance_min_m)) {
    throw std::invalid_argument("arrival within " + std::to_string(params.arrival_m) + " m of targets " +
                                std::to_string(params.distance_min_m) + " m away");
  }
  targets_.team = team;
}

const Targets& RandomTargets::update(const WorldState& world) {
  bool changed = false;
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team_) continue;
    const auto [entry, is_new] = assignments_.try_emplace(robot.id.number);
    Assignment& assignment = entry->second;
    const Vec2& position = robot.pose.position_m;
    if (is_new) {  // stands until a place is found
      assignment.target = {robot.id.number, robot.pose, params_.speed_max_mps, false};
    } else if (!assignment.counted && (position - assignment.target.pose.position_m).norm() <= params_.arrival_m) {
      assignment.counted = true;
      ++assignment.reached;
    }
    if (assignment.counted) changed |= assign(assignment, position) || is_new;
  }
  if (!changed) return targets_;
  targets_.captured = world.captured;
  ++targets_.sequence;
  targets_.targets.clear();
  for (const auto& [number, assignment] : assignments_) targets_.targets.push_back(assignment.target);
  return targets_;
}

bool RandomTargets::assign(Assignment& assignment, const Vec2& robot_position_m) {
  const double x_max = field_.length_m / 2.0 - params_.robot_radius_m;
  const double y_max = field_.width_m / 2.0 - params_.robot_radius_m;
  for (int i = 0; i < kTries; ++i) {
    const double x = random_.uniform(-x_max, x_max);
    const double y = random_.uniform(-y_max, y_max);
    const Vec2 point(x, y);
    if ((point - robot_position_m).norm() < params_.distance_min_m) continue;
    if (!is_target_place(point, field_, params_) || !keeps_gap(point, assignment.target.robot)) continue;
    const double heading = wrap_angle(random_.uniform(-std::numbers::pi, std::numbers::pi));
    assignment.target.pose = {point, heading};
    assignment.counted = false;
    return true;
  }
  return false;
}

bool RandomTargets::keeps_gap(const Vec2& point_m, std::uint16_t robot) const {
  for (const auto& [number, other] : assignments_) {
    if (number == robot) continue;
    if ((other.target.pose.position_m - point_m).norm() < params_.target_gap_m) return false;
  }
  return true;
}

std::int64_t RandomTargets::reached() const {
  std::int64_t sum = 0;
  for (const auto& [number, assignment] : assignments_) sum += assignment.reached;
  return sum;
}

std::int64_t RandomTargets::reached(std::uint16_t robot) const {
  const auto entry = assignments_.find(robot);
  return entry == assignments_.end() ? 0 : entry->second.reached;
}

}  // namespace regista
