#include "sim/random_targets.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

// Draws until a place is found; where a hundredth of the field is allowed, a thousand failures mean that it is full.
constexpr int kTries = 1000;
constexpr double kShareMin = 0.01;
// A full field must not cost a thousand draws per robot in every frame.
constexpr Duration kRetry{500'000};
// Nearer by less is no progress: robots that press against each other shake.
constexpr double kProgress_m = 0.05;

// Part of the places within the lines that are target places so far from `from_m`, by a grid.
double far_share(const Vec2& from_m, const FieldGeometry& field, const RandomTargetsParams& params) {
  constexpr int kSteps = 100;
  const Vec2 half = Vec2(field.length_m, field.width_m) / 2.0 - Vec2::Constant(params.robot_radius_m);
  int count = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Vec2 share((2.0 * i + 1.0) / kSteps - 1.0, (2.0 * j + 1.0) / kSteps - 1.0);
      const Vec2 point = half.cwiseProduct(share);
      if ((point - from_m).norm() < params.distance_min_m) continue;
      if (is_target_place(point, field, params)) ++count;
    }
  }
  return count / static_cast<double>(kSteps * kSteps);
}

}  // namespace

bool is_target_place(const Vec2& point_m, const FieldGeometry& field, const RandomTargetsParams& params) {
  const double x = std::abs(point_m.x());
  const double y = std::abs(point_m.y());
  if (x > field.length_m / 2.0 - params.robot_radius_m || y > field.width_m / 2.0 - params.robot_radius_m) return false;
  const double grown = params.robot_radius_m + params.area_margin_m;
  return x < field.length_m / 2.0 - field.defence_depth_m - grown || y > field.defence_width_m / 2.0 + grown;
}

void require_far_places(const FieldGeometry& field, const RandomTargetsParams& params) {
  // The field is its own mirror image along both axes: one quarter is enough. The farthest place is nearest seen from
  // the centre; how many there are is looked at from the middles of the sides and the corner too.
  for (const Vec2& part : {Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0), Vec2(1.0, 1.0)}) {
    const Vec2 from = part.cwiseProduct(Vec2(field.length_m, field.width_m) / 2.0);
    const double share = far_share(from, field, params);
    if (share >= kShareMin) continue;
    throw std::invalid_argument("targets at least " + std::to_string(params.distance_min_m) + " m away, but only " +
                                std::to_string(100.0 * share) + " % of a field of " + std::to_string(field.length_m) +
                                " x " + std::to_string(field.width_m) + " m are so far from (" +
                                std::to_string(from.x()) + ", " + std::to_string(from.y()) +
                                ") m and outside the defence areas");
  }
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
  if (!(params.give_up_s >= 0.0 && std::isfinite(params.give_up_s))) {
    throw std::invalid_argument("giving up after " + std::to_string(params.give_up_s) + " s");
  }
  require_far_places(field, params);
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
    if (assignment.counted || has_given_up(assignment, position, world.captured)) {
      changed |= assign(assignment, position, world.captured) || is_new;
    }
  }
  if (!changed) return targets_;
  targets_.captured = world.captured;
  ++targets_.sequence;
  targets_.targets.clear();
  for (const auto& [number, assignment] : assignments_) targets_.targets.push_back(assignment.target);
  return targets_;
}

bool RandomTargets::has_given_up(Assignment& assignment, const Vec2& robot_position_m, Time now) const {
  const double distance_m = (robot_position_m - assignment.target.pose.position_m).norm();
  // Time goes back where the source of vision begins anew.
  if (distance_m <= assignment.nearest_m - kProgress_m || now < assignment.nearest_at) {
    assignment.nearest_m = distance_m;
    assignment.nearest_at = now;
  }
  return params_.give_up_s > 0.0 && to_seconds(now - assignment.nearest_at) >= params_.give_up_s;
}

bool RandomTargets::assign(Assignment& assignment, const Vec2& robot_position_m, Time now) {
  const bool waits = now < assignment.next_try && assignment.next_try - now <= kRetry;
  if (waits) return false;
  if (!draw(assignment, robot_position_m)) {
    assignment.next_try = now + kRetry;
    return false;
  }
  assignment.nearest_m = (assignment.target.pose.position_m - robot_position_m).norm();
  assignment.nearest_at = now;
  return true;
}

bool RandomTargets::draw(Assignment& assignment, const Vec2& robot_position_m) {
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
