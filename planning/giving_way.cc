#include "planning/giving_way.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace regista {
namespace {

/// Places to go to lie on circles that far apart, so many on each.
constexpr double kStep_m = 0.2;
constexpr int kDirections = 16;

/// Who stands this far from the other's way by now stays there; who has to leave it goes a little farther, so that
/// noise does not set him off again.
constexpr double kClear_m = 0.02;
constexpr double kClearer_m = 0.06;

/// Who is so near to the goal has arrived: nobody waits for him to pass.
constexpr double kArrived_m = 0.05;

/// Where both ways out are about equal, the higher number goes.
constexpr double kAboutEqual_m = 0.1;

double distance_m(const Vec2& point, std::span<const Vec2> path) {
  double least_m = (point - path.front()).norm();
  for (std::size_t i = 1; i < path.size(); ++i) {
    least_m = std::min(least_m, (point - nearest_on_segment(point, path[i - 1], path[i])).norm());
  }
  return least_m;
}

}  // namespace

void GivingWay::resolve(Planner& planner, graph::SharedGraph& graph, std::span<Traveller> travellers,
                        std::span<const std::size_t> mates, double within_m) {
  if (within_m <= 0.0) return;
  planner_ = &planner;
  graph_ = &graph;
  travellers_ = travellers;
  mates_ = mates;
  within_m_ = within_m;
  ways_.assign(travellers.size(), std::nullopt);
  std::vector<std::pair<Plan*, Plan>> changes;  // who gives way is decided by what was planned
  for (std::size_t i = 0; i < travellers.size(); ++i) {
    const std::optional<std::size_t> other =
        travellers[i].plan->status == PlanStatus::unreachable ? first_met(i) : std::nullopt;
    if (!other) continue;
    const Plan& way = way_of(*other);
    if (way.status != PlanStatus::ok || way.length_m < kArrived_m || !closes_alone(i, *other)) continue;
    std::optional<Plan> out = way_out(i, way.path);
    if (!out || !yields(i, *other, out->length_m)) continue;
    out->status = PlanStatus::unreachable;
    out->reason = "obstacles close every way; gives way to a team-mate";
    changes.emplace_back(travellers[i].plan, std::move(*out));
  }
  for (auto& [plan, change] : changes) *plan = std::move(change);
}

/// The request of one to whom no team-mate is an obstacle.
PlanRequest GivingWay::without_mates(std::size_t traveller) const {
  PlanRequest request = travellers_[traveller].request;
  std::vector<std::size_t> ignored;
  std::ranges::set_union(request.ignored, mates_, std::back_inserter(ignored));
  request.ignored = std::move(ignored);
  return request;
}

const Plan& GivingWay::way_of(std::size_t traveller) {
  std::optional<Plan>& way = ways_[traveller];
  if (!way) way = plan_or_invalid(*planner_, *graph_, without_mates(traveller));
  return *way;
}

/// In a crowd there is a way again soon, whoever closes it.
bool GivingWay::closes_alone(std::size_t traveller, std::size_t other) {
  PlanRequest request = without_mates(traveller);
  std::erase(request.ignored, travellers_[other].obstacle);
  return plan_or_invalid(*planner_, *graph_, request).status == PlanStatus::unreachable;
}

/// The team-mate that stands first in a robot's way, if it has one but for its team-mates, and if that one is a
/// traveller, too.
std::optional<std::size_t> GivingWay::first_met(std::size_t traveller) {
  const Plan& way = way_of(traveller);
  if (way.status != PlanStatus::ok) return std::nullopt;
  const std::span<const Obstacle> obstacles = graph_->field().obstacles();
  std::size_t first = travellers_[traveller].obstacle;
  for (std::size_t leg = 1; leg < way.path.size() && first == travellers_[traveller].obstacle; ++leg) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const std::size_t mate : mates_) {
      if (mate == travellers_[traveller].obstacle) continue;
      if (is_free(way.path[leg - 1], way.path[leg], obstacles[mate])) continue;
      const double from_m = (obstacles[mate].a - way.path[leg - 1]).norm();
      if (from_m < nearest_m) first = mate;
      nearest_m = std::min(nearest_m, from_m);
    }
  }
  const auto met = std::ranges::find(travellers_, first, &Traveller::obstacle);
  const auto index = static_cast<std::size_t>(met - travellers_.begin());
  return met == travellers_.end() || index == traveller ? std::nullopt : std::optional(index);
}

/// To the nearest place from which the robot does not reach into that path.
std::optional<Plan> GivingWay::way_out(std::size_t traveller, std::span<const Vec2> of_other) {
  const ObstacleField& field = graph_->field();
  PlanRequest request = travellers_[traveller].request;
  const Vec2 here = request.start;
  const double reach_m = field.obstacles()[travellers_[traveller].obstacle].radius_m;
  std::optional<Plan> best;
  if (distance_m(here, of_other) >= reach_m + kClear_m) {
    request.goal = here;
    best = plan_or_invalid(*planner_, *graph_, request);
    if (best->path.size() == 1) return best;
    best.reset();
  }
  request.length_max_m = within_m_;
  for (double radius_m = kStep_m; radius_m < request.length_max_m; radius_m += kStep_m) {
    for (int k = 0; k < kDirections; ++k) {
      const double angle_rad = 2.0 * std::numbers::pi * k / kDirections;
      request.goal = here + radius_m * Vec2(std::cos(angle_rad), std::sin(angle_rad));
      if (distance_m(request.goal, of_other) < reach_m + kClearer_m) continue;
      if (!is_inside(request.goal, field.bounds())) continue;
      if (field.first_blocker(request.goal, request.goal, request.ignored)) continue;
      Plan plan = plan_or_invalid(*planner_, *graph_, request);
      if (plan.status != PlanStatus::ok || plan.length_m >= request.length_max_m) continue;
      request.length_max_m = plan.length_m;
      best = std::move(plan);
    }
  }
  return best;
}

/// Not where the other one is in the same case, and gets out of the way more easily than by length_m.
bool GivingWay::yields(std::size_t traveller, std::size_t other, double length_m) {
  if (travellers_[other].plan->status != PlanStatus::unreachable || first_met(other) != traveller) return true;
  const std::optional<Plan> out = way_out(other, way_of(traveller).path);
  if (!out) return true;
  const bool is_higher = travellers_[traveller].obstacle > travellers_[other].obstacle;
  return length_m < out->length_m + (is_higher ? kAboutEqual_m : -kAboutEqual_m);
}

}  // namespace regista
