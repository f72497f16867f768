#include "planning/planners/dvg_objects.h"

#include <numeric>

namespace regista::dvg {
namespace {

/// For each object the smallest index of its group.
std::vector<std::size_t> group_of(const std::vector<Object>& objects, double group_distance_m) {
  std::vector<std::size_t> first(objects.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((objects[i].centre - objects[j].centre).norm() >= group_distance_m) continue;
      const std::size_t one = root(i);
      const std::size_t other = root(j);
      first[std::max(one, other)] = std::min(one, other);
    }
  }
  for (std::size_t i = 0; i < objects.size(); ++i) first[i] = root(i);
  return first;
}

Object merged(const std::vector<Object>& members) {
  Object group{Vec2::Zero(), 0.0, true};
  for (const Object& member : members) group.centre += member.centre;
  group.centre /= static_cast<double>(members.size());
  for (const Object& member : members) {
    group.radius_m = std::max(group.radius_m, (member.centre - group.centre).norm() + member.radius_m);
  }
  return group;
}

bool holds(const Object& object, const Vec2& point) { return (point - object.centre).norm() < object.radius_m; }

}  // namespace

void group_near(std::vector<Object>& objects, const Vec2& start, const Vec2& goal, double group_distance_m) {
  const std::vector<std::size_t> groups = group_of(objects, group_distance_m);
  std::vector<Object> out;
  std::vector<Object> members;
  for (std::size_t first = 0; first < objects.size(); ++first) {
    if (groups[first] != first) continue;
    members.clear();
    for (std::size_t i = first; i < objects.size(); ++i) {
      if (groups[i] == first) members.push_back(objects[i]);
    }
    const Object group = merged(members);
    if (members.size() > 1 && !holds(group, start) && !holds(group, goal)) {
      out.push_back(group);
    } else {
      out.insert(out.end(), members.begin(), members.end());
    }
  }
  objects = std::move(out);
}

void grow_far(std::vector<Object>& objects, const Vec2& start, const Vec2& goal, const DvgParams& params) {
  for (Object& object : objects) {
    const double to_goal_m = (goal - object.centre).norm();
    const double to_start_m = (start - object.centre).norm();
    const double wanted_m = object.radius_m + params.growth * (to_goal_m - params.unchanged_within_m);
    const double radius_m = std::min(std::min(wanted_m, params.radius_max_m), std::min(to_goal_m, to_start_m));
    if (radius_m <= object.radius_m) continue;
    object.radius_m = radius_m;
    object.is_enlarged = true;
  }
}

}  // namespace regista::dvg
