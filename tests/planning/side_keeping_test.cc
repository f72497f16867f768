// Robots stay on their side of obstacles, whatever they plan with, until the other side is clearly shorter.
#include "planning/side_keeping.h"

#include <catch2/catch.hpp>

#include "planning/path_sides.h"
#include "planning/registry.h"
#include "planning/team_planner.h"
#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

constexpr double kGain = 0.1;

bool same_side(const ObstacleField& field, const PlanRequest& request, const Plan& plan) {
  std::vector<ObstacleIndex> out;
  append_passed_otherwise(field.obstacles(), request.ignored, request.previous_path, plan.path, out);
  return out.empty();
}

/// Past a disc on the straight line whose middle is `above_m` beside it, following a path that passes below the disc.
struct PastOne {
  ObstacleField field;
  PlanRequest request;
  explicit PastOne(double above_m) : field({{6, 4}}, {disc({0, above_m}, 0.5)}) {
    request.start = {-2, 0};
    request.goal = {2, 0};
    request.previous_path = {{-2.02, 0}, {0, -0.8}, {2, 0}};
  }
};

/// One robot behind a standing opponent, seen with vision noise. Returns the changes of side in that many frames.
int changes_of_side(std::string_view planner_name, double gain, int frames) {
  PlanningParams params;
  params.side_change_gain = gain;
  TeamPlanner planner(Team::yellow, params);
  planner.use(planner_name);
  std::mt19937_64 random(7);
  WorldState world;
  world.robots.resize(2);
  world.robots[0].id = {Team::yellow, 0};
  world.robots[1].id = {Team::blue, 0};
  Targets targets;
  targets.targets.resize(1);
  targets.targets[0].pose.position_m = {1.5, 0};
  std::optional<RobotPlan> before;
  int changes = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    constexpr double kNoise_m = 0.005;
    const auto noise = [&] { return Vec2(uniform(random, -kNoise_m, kNoise_m), uniform(random, -kNoise_m, kNoise_m)); };
    world.sequence = static_cast<std::uint64_t>(frame);
    world.robots[0].pose.position_m = Vec2(-1.5, 0) + noise();
    world.robots[1].pose.position_m = noise();
    const TeamObstacles obstacles = obstacles_for(Team::yellow, division_a(), world, params);
    const RobotPlan now = planner.plan(division_a(), world, targets).plans.at(0);
    const auto ignored = ignored_by(obstacles, now.robot, false);
    changes += before && changes_side(obstacles.field, ignored, *before, now);
    before = now;
  }
  return changes;
}

}  // namespace

TEST_CASE("noise changes no robot's side, whatever it plans with") {
  int without = 0;
  for (const PlannerEntry& entry : planners()) {
    CAPTURE(entry.name);
    const int frames = entry.guarantees.deterministic ? 60 : 15;
    without += changes_of_side(entry.name, 0.0, frames);
    // Random planners change when they stumble over a way that is shorter by more; those that must not, are exact.
    const int changes = changes_of_side(entry.name, 0.05, frames);
    CHECK(changes <= (entry.guarantees.deterministic ? 0 : 3));
  }
  CHECK(changes_of_side("tangent", 0.0, 60) >= 15);
  CHECK(without >= 100);
}

TEST_CASE("the side is kept until the other one is clearly shorter") {
  const auto planner = make_planner("tangent");
  SideKeeper keeper;
  int kept = 0;
  double longest_ratio = 1.0;
  for (double below_m = 0.0; below_m < 0.45; below_m += 0.01) {
    const PastOne scene(-below_m);  // the disc comes down upon the path followed
    const Plan shortest = planner->plan(scene.field, scene.request);
    Plan plan = shortest;
    keeper.keep(*planner, scene.field, scene.request, kGain, plan);
    CAPTURE(below_m);
    REQUIRE(testing::fault_of(scene.field, scene.request, plan) == "");
    const double ratio = plan.length_m / shortest.length_m;
    if (same_side(scene.field, scene.request, plan)) {
      REQUIRE(ratio <= 1.0 + kGain);
      longest_ratio = std::max(longest_ratio, ratio);
      ++kept;
    } else {
      REQUIRE(plan == shortest);
    }
  }
  CHECK(longest_ratio > 1.0 + 0.8 * kGain);
  CHECK(kept < 45);
}

TEST_CASE("a side that is closed is given up") {
  PastOne scene(-0.05);
  std::vector<Obstacle> obstacles(scene.field.obstacles().begin(), scene.field.obstacles().end());
  obstacles.push_back(rounded_rectangle({-0.2, -5}, {0.2, -0.4}, 0.1));
  scene.field = ObstacleField(scene.field.bounds(), obstacles);
  const auto planner = make_planner("tangent");
  const Plan shortest = planner->plan(scene.field, scene.request);
  REQUIRE(shortest.status == PlanStatus::ok);
  REQUIRE_FALSE(same_side(scene.field, scene.request, shortest));
  Plan plan = shortest;
  SideKeeper().keep(*planner, scene.field, scene.request, 10.0, plan);
  CHECK(plan == shortest);
}

TEST_CASE("what has no side is left alone") {
  const auto planner = make_planner("tangent");
  SideKeeper keeper;
  PastOne scene(-0.05);
  const Plan shortest = planner->plan(scene.field, scene.request);
  const auto keeps = [&] {
    Plan plan = shortest;
    keeper.keep(*planner, scene.field, scene.request, kGain, plan);
    return plan != shortest;
  };
  CHECK(keeps());
  scene.request.previous_path.back() = {2, 1};  // another goal
  CHECK_FALSE(keeps());
  scene.request.previous_path = {{-3, 0}, {0, -0.8}, {2, 0}};  // put elsewhere
  CHECK_FALSE(keeps());
  scene.request.previous_path.clear();
  CHECK_FALSE(keeps());
}

TEST_CASE("a planner that is out of luck keeps the path it followed") {
  PastOne scene(-0.02);
  const auto planner = make_planner("tangent");
  const Plan shortest = planner->plan(scene.field, scene.request);
  const auto luckless = make_planner("rrt");
  scene.request.budget.iterations = 0;
  Plan plan = shortest;
  SideKeeper().keep(*luckless, scene.field, scene.request, kGain, plan);
  CHECK(plan.path == std::vector<Vec2>{{-2, 0}, {0, -0.8}, {2, 0}});
  CHECK(plan.length_m == Approx(length_of(plan.path)));
}

TEST_CASE("in random worlds what is kept is free, on the side followed, not much longer, and the same each time") {
  std::mt19937_64 random(41);
  const auto planner = make_planner("tangent");
  SideKeeper keeper;
  int turned = 0;
  int kept = 0;
  for (int world = 0; world < 2000; ++world) {
    const ObstacleField field = testing::random_field(random, 25);
    PlanRequest request = testing::random_free_request(random, field);
    // What it followed: a way through a world in which everything stood a little elsewhere.
    std::vector<Obstacle> elsewhere(field.obstacles().begin(), field.obstacles().end());
    for (Obstacle& obstacle : elsewhere) {
      const Vec2 shift(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2));
      obstacle.a += shift;
      obstacle.b += shift;
    }
    request.previous_path = planner->plan(ObstacleField(field.bounds(), elsewhere), request).path;
    const Plan shortest = planner->plan(field, request);
    if (shortest.status != PlanStatus::ok || !is_same_errand(request.previous_path, shortest.path)) continue;
    Plan plan = shortest;
    keeper.keep(*planner, field, request, kGain, plan);
    Plan again = shortest;
    SideKeeper().keep(*planner, field, request, kGain, again);
    CAPTURE(world);
    REQUIRE(plan == again);
    REQUIRE(testing::fault_of(field, request, plan) == "");
    REQUIRE(plan.length_m <= (1.0 + kGain) * shortest.length_m);
    turned += !same_side(field, request, shortest);
    kept += plan != shortest;
    if (plan != shortest) REQUIRE(same_side(field, request, plan));
  }
  INFO("turned " << turned << ", kept " << kept);
  CHECK(turned >= 40);
  CHECK(kept >= turned / 2);
}

}  // namespace regista
