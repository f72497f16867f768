#include "planning/out_of_the_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace regista {
namespace {

/// Places to go to lie on a grid that is fixed in the field, so that the one chosen stays while a robot goes there.
constexpr double kGrid_m = 0.2;

/// The exact planner needs microseconds for a way, more for a proof that there is none.
constexpr int kPlansMax = 64;

/// Who stands this far from the other's way by now stays there; who has to leave it goes a little farther, so that
/// noise does not set him off again.
constexpr double kClear_m = 0.02;
constexpr double kClearer_m = 0.06;

/// The leg stays at least that far from the path.
bool is_apart(const Vec2& from, const Vec2& to, std::span<const Vec2> path, double apart_m) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!is_free(from, to, capsule(path[i > 0 ? i - 1 : 0], path[i], apart_m))) return false;
  }
  return true;
}

}  // namespace

Plan OutOfTheWay::plan(const Traveller& traveller, const Vec2& goal, std::vector<std::size_t> ignored,
                       double length_max_m) {
  PlanRequest request;
  request.start = traveller.start;
  request.goal = goal;
  request.ignored = std::move(ignored);
  request.length_max_m = length_max_m;
  return plan_or_invalid(planner_, graph_, request);
}

bool OutOfTheWay::is_clear(const Traveller& traveller, std::span<const Vec2> of_other) const {
  const Vec2& here = traveller.start;
  return is_apart(here, here, of_other, reach_m(traveller) + kClear_m);
}

/// The robot's own plan as far as it keeps off that path.
Plan OutOfTheWay::held_back(const Traveller& traveller, std::span<const Vec2> of_other) const {
  Plan plan = *traveller.plan;
  const double apart_m = reach_m(traveller) + kClearer_m;
  const auto is_off = [&](const Vec2& from, const Vec2& to) { return is_apart(from, to, of_other, apart_m); };
  if (plan.path.empty()) plan.path.push_back(traveller.start);
  std::size_t kept = 1;
  while (kept < plan.path.size() && is_off(plan.path[kept - 1], plan.path[kept])) ++kept;
  if (kept < plan.path.size()) {
    constexpr int kHalvings = 12;
    Vec2 part = plan.path[kept] - plan.path[kept - 1];
    Vec2 to = plan.path[kept - 1];
    for (int i = 0; i < kHalvings; ++i) {
      part *= 0.5;
      if (is_off(to, to + part)) to += part;
    }
    plan.path.resize(kept);
    if (to != plan.path.back()) plan.path.push_back(to);
  }
  plan.length_m = length_of(plan.path);
  return plan;
}

/// To the nearest place from which the robot does not reach into that path.
std::optional<Plan> OutOfTheWay::way_out(const Traveller& traveller, std::span<const Vec2> of_other, double within_m) {
  const Vec2& here = traveller.start;
  const auto distance_m = [&](const Vec2& place) { return (place - here).norm(); };
  std::optional<Plan> best;
  double best_m = within_m;
  int plans = 0;
  for (const Vec2& place : places(traveller, of_other, within_m)) {
    if (distance_m(place) >= best_m || ++plans > kPlansMax) break;
    Plan way = plan(traveller, place, traveller.ignored, best_m);
    if (way.status != PlanStatus::ok || way.length_m >= best_m) continue;
    best_m = way.length_m;
    best = std::move(way);
  }
  return best;
}

/// Free ones clear of that path, the nearest first.
std::vector<Vec2> OutOfTheWay::places(const Traveller& traveller, std::span<const Vec2> of_other,
                                      double within_m) const {
  const Vec2& here = traveller.start;
  const double apart_m = reach_m(traveller) + kClearer_m;
  std::vector<Vec2> out;
  const Vec2 low = ((here.array() - within_m) / kGrid_m).ceil();
  const Vec2 high = ((here.array() + within_m) / kGrid_m).floor();
  for (double x = low.x(); x <= high.x(); ++x) {
    for (double y = low.y(); y <= high.y(); ++y) {
      const Vec2 place = kGrid_m * Vec2(x, y);
      if (!is_inside(place, field().bounds()) || !is_apart(place, place, of_other, apart_m)) continue;
      if (!field().first_blocker(place, place, traveller.ignored)) out.push_back(place);
    }
  }
  std::ranges::stable_sort(out, {}, [&](const Vec2& place) { return (place - here).squaredNorm(); });
  return out;
}

}  // namespace regista
