#include "modules/bench/paper/dvg_dynamic.h"

#include <limits>
#include <stdexcept>

#include "modules/bench/paper/dvg_scenario.h"
#include "modules/bench/paper/toml_file.h"
#include "planning/planner.h"
#include "planning/planners/dvg_published.h"
#include "world_model/types/robot_limits.h"

namespace regista::bench {
namespace {

constexpr int kStepsPerFrame = 4;
constexpr double kStep_s = 1.0 / 60.0 / kStepsPerFrame;
constexpr double kCrossed_m = 0.09;      // "a threshold distance of 90 mm, which is the radius of the robot"
constexpr double kContact_m = 0.18;      // centres of two robots of 90 mm
constexpr double kCollisionGap_s = 0.5;  // "a time window of 0.5 s"
constexpr double kArrived_m = 0.005;
constexpr double kGiveUp_s = 60.0;  // seven times the longest run printed

/// A point that moves along a polyline.
class Tracker {
 public:
  Tracker(const Vec2& start, double speed_max_mps) : path_{start}, speed_max_mps_(speed_max_mps) {}

  Vec2 place() const { return path_.front(); }
  /// What is still to be driven, from the robot's place on.
  std::span<const Vec2> rest() const { return path_; }
  void follow(std::vector<Vec2> path) { path_ = std::move(path); }

  void step(bool may_drive) {
    const double rest_m = length_of(path_);
    const double wanted_mps =
        may_drive ? std::min(speed_max_mps_, std::sqrt(2.0 * limits_.braking_max_mps2 * rest_m)) : 0.0;
    speed_mps_ = std::clamp(wanted_mps, std::max(0.0, speed_mps_ - limits_.braking_max_mps2 * kStep_s),
                            speed_mps_ + limits_.acceleration_max_mps2 * kStep_s);
    advance(std::min(rest_m, speed_mps_ * kStep_s));
  }

 private:
  void advance(double way_m) {
    while (path_.size() > 1) {
      const double leg_m = (path_[1] - path_[0]).norm();
      if (way_m < leg_m) {
        path_[0] += (path_[1] - path_[0]) * (way_m / leg_m);
        return;
      }
      way_m -= leg_m;
      path_.erase(path_.begin());
    }
  }

  RobotLimits limits_;
  std::vector<Vec2> path_;  ///< from the robot's place on
  double speed_max_mps_;
  double speed_mps_ = 0.0;
};

class Collisions {
 public:
  void look(std::span<const dvg::Object> objects, const Vec2& robot, double time_s) {
    const bool touches = std::any_of(objects.begin(), objects.end(), [&](const dvg::Object& object) {
      return (object.centre - robot).norm() < kContact_m;
    });
    if (!touches || time_s - last_s_ < kCollisionGap_s) return;
    last_s_ = time_s;
    ++count_;
  }
  std::size_t count() const { return count_; }

 private:
  double last_s_ = -std::numeric_limits<double>::infinity();
  std::size_t count_ = 0;
};

bool is_crossed(std::span<const Vec2> path, std::span<const dvg::Object> objects) {
  return std::any_of(objects.begin(), objects.end(),
                     [&](const dvg::Object& object) { return distance_m(object.centre, path) < kCrossed_m; });
}

}  // namespace

DynamicScenario load_dynamic_scenario(const std::string& name) {
  return read_paper_file(name + ".toml", [](const toml::table& file) {
    DynamicScenario scenario;
    scenario.title = required<std::string>(file, "title");
    scenario.rebuilt = required<std::string>(file, "rebuilt");
    scenario.start = point_of(file.get("start"), "start");
    scenario.goal = point_of(file.get("goal"), "goal");
    scenario.speed_mps = required<double>(file, "speed_mps");
    for (const toml::node& node : required_list(file, "obstacles")) {
      const toml::array* ends = node.as_array();
      if (ends == nullptr || ends->size() != 2) throw std::runtime_error("'obstacles' must be pairs of points");
      scenario.obstacles.push_back({point_of(ends->get(0), "obstacles"), point_of(ends->get(1), "obstacles")});
    }
    return scenario;
  });
}

Vec2 place_of(const Crossing& crossing, double speed_mps, double phase, double time_s) {
  const double there_m = (crossing.b - crossing.a).norm();
  if (there_m == 0.0) return crossing.a;
  const double turns = phase + time_s * speed_mps / (2.0 * there_m);
  const double share = 2.0 * (turns - std::floor(turns));
  return crossing.a + (crossing.b - crossing.a) * (share < 1.0 ? share : 2.0 - share);
}

Drive drive(const DynamicScenario& scenario, std::span<const double> phases, const Replan& replan) {
  if (phases.size() != scenario.obstacles.size()) {
    throw std::invalid_argument(std::to_string(phases.size()) + " phases for " +
                                std::to_string(scenario.obstacles.size()) + " obstacles");
  }
  Drive out;
  Tracker robot(scenario.start, scenario.speed_mps);
  Collisions collisions;
  std::vector<dvg::Object> objects(phases.size(), {Vec2::Zero(), dvg::kRobotObject_m});
  bool has_path = false;
  for (int step = 0; static_cast<double>(step) * kStep_s < kGiveUp_s; ++step) {
    const double time_s = static_cast<double>(step) * kStep_s;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      objects[i].centre = place_of(scenario.obstacles[i], scenario.speed_mps, phases[i], time_s);
    }
    collisions.look(objects, robot.place(), time_s);
    if ((robot.place() - scenario.goal).norm() < kArrived_m) {
      out.arrived = true;
      out.navigation_s = time_s;
      break;
    }
    if (step % kStepsPerFrame == 0 && (!has_path || is_crossed(robot.rest(), objects))) {
      if (step > 0) ++out.recalculated;
      std::vector<Vec2> path = replan(objects, robot.place());
      has_path = path.size() > 1;
      if (has_path) robot.follow(std::move(path));
    }
    robot.step(has_path);
  }
  out.collisions = collisions.count();
  return out;
}

}  // namespace regista::bench
