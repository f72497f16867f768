// The DVG paper's scenarios make sense, static and dynamic, and drives among what moves in them.
#include <catch2/catch.hpp>

#include "modules/bench/paper/dvg_drives.h"
#include "modules/bench/paper/dvg_dynamic.h"
#include "modules/bench/paper/dvg_entrant.h"
#include "planning/planners/dvg_region.h"

namespace regista::bench {
namespace {

constexpr std::array kStatic{"dvg_connections", "dvg_worst_dvg", "dvg_worst_rrt", "dvg_mixed", "dvg_stoppage"};

TEST_CASE("static scenarios: robots do not stand in each other, ends are free, the straight line is not") {
  for (const char* name : kStatic) {
    const DvgScenario scenario = load_dvg_scenario(name);
    const ObjectsQuery query = query_of(scenario);
    const World world = world_of(query);
    CHECK_FALSE(scenario.rebuilt.empty());
    CHECK(query.objects.size() == scenario.robots.size() + (scenario.ball ? 1 : 0));
    for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
      INFO(name << ", robot " << i);
      CHECK(is_inside(scenario.robots[i], world.bounds));
      for (std::size_t j = 0; j < i; ++j) CHECK((scenario.robots[i] - scenario.robots[j]).norm() >= 0.18);
    }
    const ObstacleField field(world.bounds, world.obstacles);
    INFO(name);
    CHECK(field.is_free(scenario.start));
    CHECK(field.is_free(scenario.goal));
    CHECK_FALSE(field.is_free(scenario.start, scenario.goal));
  }
  const DvgScenario worst = load_dvg_scenario("dvg_worst_dvg");
  CHECK(worst.robots.size() == 15);
  const dvg::ActiveRegion region(worst.start, worst.goal, 1.0);
  for (const Vec2& robot : worst.robots) {
    CHECK(region.is_reached_by(dvg::octagon(robot, dvg::kRobotObject_m).vertices()));
  }
  CHECK(load_dvg_scenario("dvg_worst_rrt").rrt_samples == 5000);
  CHECK(load_dynamic_scenario("dvg_dynamic_1").obstacles.size() == 7);
  CHECK(load_dynamic_scenario("dvg_dynamic_2").obstacles.size() == 5);
  CHECK_THROWS_WITH(load_dvg_scenario("no_such_scenario"), Catch::Contains("no_such_scenario"));
}

TEST_CASE("obstacles of the dynamic scenarios all cross the line and leave the goal free") {
  for (const char* name : kDynamicScenarios) {
    const DynamicScenario scenario = load_dynamic_scenario(name);
    for (const Crossing& crossing : scenario.obstacles) {
      CHECK(cross(scenario.goal - scenario.start, crossing.a - scenario.start) *
                cross(scenario.goal - scenario.start, crossing.b - scenario.start) <
            0.0);
      for (const Vec2& end : {scenario.start, scenario.goal}) {
        CHECK((nearest_on_segment(end, crossing.a, crossing.b) - end).norm() > dvg::kRobotObject_m);
      }
    }
  }
}

TEST_CASE("an obstacle goes to and fro at its speed") {
  const Crossing crossing{{0.0, -1.0}, {0.0, 1.0}};
  CHECK(place_of(crossing, 2.0, 0.0, 0.0).y() == Approx(-1.0));
  CHECK(place_of(crossing, 2.0, 0.0, 0.25).y() == Approx(-0.5));
  CHECK(place_of(crossing, 2.0, 0.0, 1.25).y() == Approx(0.5));
  CHECK(place_of(crossing, 2.0, 0.0, 2.0).y() == Approx(-1.0));
  CHECK(place_of(crossing, 2.0, 0.5, 0.0).y() == Approx(1.0));
  for (double time_s = 0.0; time_s < 10.0; time_s += 0.01) {
    const Vec2 step = place_of(crossing, 2.0, 0.3, time_s + 0.01) - place_of(crossing, 2.0, 0.3, time_s);
    CHECK(step.norm() <= 0.02 + 1e-12);
  }
}

std::vector<Vec2> straight(std::span<const dvg::Object>, const Vec2& from) { return {from, {5.0, 0.0}}; }

TEST_CASE("a drive alone takes the time of a trapezoid, and none recalculates") {
  const DynamicScenario empty{"", "", {-5.0, 0.0}, {5.0, 0.0}, 2.5, {}};
  const Drive alone = drive(empty, {}, straight);
  // 10 m at 2.5 m/s, and half of the time of speeding up with 3 m/s² and of braking with 4 m/s².
  CHECK(alone.arrived);
  CHECK(alone.navigation_s == Approx(10.0 / 2.5 + 2.5 / 3.0 / 2.0 + 2.5 / 4.0 / 2.0).margin(0.1));
  CHECK(alone.recalculated == 0);
  CHECK(alone.collisions == 0);
}

TEST_CASE("a drive through an obstacle: one collision, a new path asked for in every frame until it is passed") {
  const DynamicScenario one{"", "", {-5.0, 0.0}, {5.0, 0.0}, 2.5, {{{0.0, 0.0}, {0.0, 0.0}}}};
  const Drive through = drive(one, std::vector<double>{0.0}, straight);
  CHECK(through.arrived);
  CHECK(through.collisions == 1);
  CHECK(through.recalculated > 100);
  const DynamicScenario beside{"", "", {-5.0, 0.0}, {5.0, 0.0}, 2.5, {{{0.0, 0.1}, {0.0, 0.1}}}};
  const Drive near = drive(beside, std::vector<double>{0.0}, straight);
  CHECK(near.collisions == 1);    // bodies touch at 0.18 m
  CHECK(near.recalculated == 0);  // the path is crossed at 0.09 m only
  CHECK_THROWS_AS(drive(one, {}, straight), std::invalid_argument);
}

TEST_CASE("collisions half a second apart count again, and no path means standing") {
  // Stands on the start: the robot, which gets no path, is in contact all the time.
  const DynamicScenario blocked{"", "", {0.0, 0.0}, {5.0, 0.0}, 2.5, {{{0.0, 0.1}, {0.0, 0.1}}}};
  const Drive none = drive(blocked, std::vector<double>{0.0}, [](auto, const Vec2&) { return std::vector<Vec2>{}; });
  CHECK_FALSE(none.arrived);
  CHECK(none.collisions == Approx(120).margin(1));  // a minute
}

}  // namespace
}  // namespace regista::bench
