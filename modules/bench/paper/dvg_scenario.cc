#include "modules/bench/paper/dvg_scenario.h"

#include <limits>

#include "modules/bench/paper/toml_file.h"

namespace regista::bench {
namespace {

constexpr double kBody_m = 0.09;  // radius of a robot
const Bounds kField{{6.0, 4.5}};  // 12 x 9 m; the paper says nothing of the strip around it

}  // namespace

DvgScenario load_dvg_scenario(const std::string& name) {
  return read_paper_file(name + ".toml", [](const toml::table& file) {
    DvgScenario scenario;
    scenario.title = required<std::string>(file, "title");
    scenario.rebuilt = required<std::string>(file, "rebuilt");
    scenario.start = point_of(file.get("start"), "start");
    scenario.goal = point_of(file.get("goal"), "goal");
    for (const toml::node& robot : required_list(file, "robots")) {
      scenario.robots.push_back(point_of(&robot, "robots"));
    }
    if (const toml::node* ball = file.get("ball")) {
      scenario.ball = dvg::Object{point_of(ball, "ball"), required<double>(file, "ball_object_m")};
    }
    scenario.rrt_samples = required<std::int64_t>(file, "rrt_samples");
    scenario.group_distance_m = file["group_distance_m"].value_or(scenario.group_distance_m);
    return scenario;
  });
}

ObjectsQuery query_of(const DvgScenario& scenario) {
  ObjectsQuery query{{}, scenario.start, scenario.goal, scenario.rrt_samples};
  for (const Vec2& robot : scenario.robots) query.objects.push_back({robot, dvg::kRobotObject_m});
  if (scenario.ball) query.objects.push_back(*scenario.ball);
  return query;
}

World world_of(const ObjectsQuery& query) {
  World world{kField, {}};
  for (const dvg::Object& object : query.objects) world.obstacles.push_back(disc(object.centre, object.radius_m));
  return world;
}

double distance_m(const Vec2& point, std::span<const Vec2> path) {
  double nearest_m = path.empty() ? std::numeric_limits<double>::infinity() : (path[0] - point).norm();
  for (std::size_t i = 1; i < path.size(); ++i) {
    nearest_m = std::min(nearest_m, (nearest_on_segment(point, path[i - 1], path[i]) - point).norm());
  }
  return nearest_m;
}

double safety_m(std::span<const dvg::Object> objects, std::span<const Vec2> path) {
  double sum_m = 0.0;
  for (const dvg::Object& object : objects) sum_m += distance_m(object.centre, path);
  return sum_m;
}

bool touches_robot(std::span<const dvg::Object> objects, std::span<const Vec2> path) {
  return std::any_of(objects.begin(), objects.end(), [&](const dvg::Object& object) {
    return object.radius_m == dvg::kRobotObject_m && distance_m(object.centre, path) < 2.0 * kBody_m - kTouch_m;
  });
}

}  // namespace regista::bench
