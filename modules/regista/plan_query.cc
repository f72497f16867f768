#include "modules/regista/plan_query.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "world_model/types/field.h"

namespace regista {
namespace {

using nlohmann::json;

// More than any field; squares of it stay far from overflow and rounding below kTouch_m's reach.
constexpr double kQueryLargest_m = 1e4;
constexpr double kLongestBudget_us = 1e9;
constexpr int kDeepest = 16;  // a query needs 4 levels; what is without bound overflows the stack when written

[[noreturn]] void fail(const std::string& where, const std::string& what) { throw QueryError(where + ": " + what); }

const json& member(const json& object, const std::string& key, const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end()) fail(where + key, "is missing");
  return *found;
}

double number(const json& value, const std::string& where, double low, double high) {
  if (!value.is_number()) fail(where, "must be a number");
  const auto x = value.get<double>();
  if (!(x >= low && x <= high)) {
    fail(where, value.dump() + " is outside [" + json(low).dump() + ", " + json(high).dump() + "]");
  }
  return x;
}

std::vector<double> numbers(const json& value, const std::string& where, std::size_t count) {
  if (!value.is_array() || value.size() != count) {
    fail(where, "must be a list of " + std::to_string(count) + " numbers");
  }
  std::vector<double> list;
  for (std::size_t i = 0; i < count; ++i) {
    list.push_back(number(value[i], where + "[" + std::to_string(i) + "]", -kQueryLargest_m, kQueryLargest_m));
  }
  return list;
}

const json& list(const json& value, const std::string& where) {
  if (!value.is_array()) fail(where, "must be a list");
  return value;
}

Vec2 point(const json& value, const std::string& where) {
  const std::vector<double> xy = numbers(value, where, 2);
  return {xy[0], xy[1]};
}

/// Beyond the goal lines, beyond the touch lines.
Vec2 margin_of(const json& field) {
  const auto margin = field.find("margin");
  if (margin == field.end()) return Vec2::Zero();
  if (margin->is_array()) return point(*margin, "field.margin");
  return Vec2::Constant(number(*margin, "field.margin", -kQueryLargest_m, kQueryLargest_m));
}

Bounds bounds_of(const json& query, double radius_m) {
  const json& field = member(query, "field", "");
  if (!field.is_object()) fail("field", "must be an object with length and width");
  FieldGeometry geometry;
  geometry.length_m = number(member(field, "length", "field."), "field.length", 0.0, kQueryLargest_m);
  geometry.width_m = number(member(field, "width", "field."), "field.width", 0.0, kQueryLargest_m);
  const Vec2 margin = margin_of(field);
  geometry.margin_goal_line_m = margin.x();
  geometry.margin_touch_line_m = margin.y();
  Bounds bounds{half_extent(geometry, radius_m)};
  if (bounds.half_extent_m.minCoeff() < 0.0) fail("field", "has no room for a robot of that radius");
  return bounds;
}

double grown(double own_radius_m, double radius_m, const std::string& where) {
  if (own_radius_m < 0.0) fail(where, "the radius is " + json(own_radius_m).dump() + ", must be at least 0");
  return own_radius_m + radius_m;
}

Obstacle obstacle_of(const json& value, double radius_m, const std::string& where) {
  if (!value.is_object() || value.size() != 1) fail(where, "must be an object with one of disc, capsule, rectangle");
  const std::string& shape = value.begin().key();
  const std::string inside = where + "." + shape;
  if (shape == "disc") {
    const auto v = numbers(*value.begin(), inside, 3);
    return disc({v[0], v[1]}, grown(v[2], radius_m, inside));
  }
  if (shape == "capsule") {
    const auto v = numbers(*value.begin(), inside, 5);
    return capsule({v[0], v[1]}, {v[2], v[3]}, grown(v[4], radius_m, inside));
  }
  if (shape == "rectangle") {
    const auto v = numbers(*value.begin(), inside, 5);
    if (v[0] > v[2] || v[1] > v[3]) fail(inside, "must be [xmin, ymin, xmax, ymax, r] with min at most max");
    return rounded_rectangle({v[0], v[1]}, {v[2], v[3]}, grown(v[4], radius_m, inside));
  }
  fail(where, "unknown shape '" + shape + "', known: disc, capsule, rectangle");
}

std::vector<std::size_t> ignored_of(const json& robot, std::size_t obstacles, const std::string& where) {
  std::vector<std::size_t> ignored;
  const auto found = robot.find("ignore");
  if (found == robot.end()) return ignored;
  for (const json& index : list(*found, where + "ignore")) {
    if (!index.is_number_unsigned() || index.get<std::size_t>() >= obstacles) {
      fail(where + "ignore", index.dump() + " is no index of an obstacle, there are " + std::to_string(obstacles));
    }
    ignored.push_back(index.get<std::size_t>());
  }
  std::sort(ignored.begin(), ignored.end());
  ignored.erase(std::unique(ignored.begin(), ignored.end()), ignored.end());
  return ignored;
}

PlanRequest request_of(const json& robot, std::size_t obstacles, std::uint64_t seed, const std::string& where) {
  if (!robot.is_object()) fail(where, "must be an object with start and goal");
  const std::string inside = where.empty() ? "" : where + ".";
  PlanRequest request;
  request.start = point(member(robot, "start", inside), inside + "start");
  request.goal = point(member(robot, "goal", inside), inside + "goal");
  request.ignored = ignored_of(robot, obstacles, inside);
  request.seed = seed;
  return request;
}

std::uint64_t seed_of(const json& query) {
  const auto found = query.find("seed");
  if (found == query.end()) return 1;
  if (!found->is_number_unsigned()) fail("seed", "must be a whole number, at least 0");
  return found->get<std::uint64_t>();
}

}  // namespace

json parse_line(const std::string& line) {
  json value;
  try {
    value = json::parse(line, [](int depth, json::parse_event_t, const json&) {
      if (depth > kDeepest) throw QueryError("no query: nested deeper than " + std::to_string(kDeepest) + " levels");
      return true;
    });
  } catch (const json::exception& error) {
    // Without the library's own tag "[json.exception.…] ".
    const std::string text = error.what();
    const std::size_t tag = text.find("] ");
    throw QueryError("no JSON: " + (tag == std::string::npos ? text : text.substr(tag + 2)));
  }
  if (!value.is_object()) throw QueryError("a query must be a JSON object");
  return value;
}

json id_of(const json& query) {
  const auto id = query.find("id");
  if (id == query.end()) return nullptr;
  if (!id->is_string() && !id->is_number() && !id->is_null()) fail("id", "must be a string or a number");
  return *id;
}

PlanQuery parse_query(const json& query) {
  PlanQuery out;
  const double radius_m = number(member(query, "radius", ""), "radius", 0.0, kQueryLargest_m);
  out.bounds = bounds_of(query, radius_m);
  const json& obstacles = list(member(query, "obstacles", ""), "obstacles");
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    out.obstacles.push_back(obstacle_of(obstacles[i], radius_m, "obstacles[" + std::to_string(i) + "]"));
  }
  if (const auto budget = query.find("budget_us"); budget != query.end()) {
    out.budget_us = number(*budget, "budget_us", 0.0, kLongestBudget_us);
  }
  const std::uint64_t seed = seed_of(query);
  const auto robots = query.find("robots");
  out.is_team = robots != query.end();
  if (!out.is_team) {
    out.requests.push_back(request_of(query, out.obstacles.size(), seed, ""));
    return out;
  }
  if (query.contains("start") || query.contains("goal")) fail("robots", "stands in place of start and goal");
  for (std::size_t i = 0; i < list(*robots, "robots").size(); ++i) {
    out.requests.push_back(request_of((*robots)[i], out.obstacles.size(), seed, "robots[" + std::to_string(i) + "]"));
  }
  return out;
}

}  // namespace regista
