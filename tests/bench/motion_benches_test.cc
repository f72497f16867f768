// Set pieces and the benches of motion, each in one tiny run.
#include <catch2/catch.hpp>

#include "modules/bench/motion/cost_bench.h"
#include "modules/bench/motion/dynamic_bench.h"
#include "modules/bench/motion/dynamic_drive.h"
#include "modules/bench/motion/margins_bench.h"
#include "modules/bench/motion/motion_bench.h"
#include "modules/bench/motion/scene_run.h"
#include "modules/bench/motion/shuttle.h"
#include "modules/bench/motion/swap_bench.h"
#include "tests/bench/bench_run.h"

namespace regista::bench {
namespace {

TEST_CASE("set pieces begin without contact, inside the boards") {
  for (const MotionScene& scene : swap_scenes()) {
    INFO(scene.name);
    const Vec2 half = half_extent(scene.field, 0.09);
    for (std::size_t i = 0; i < scene.robots.size(); ++i) {
      const Vec2& place = scene.robots[i].pose.position_m;
      CHECK(std::abs(place.x()) <= half.x());
      CHECK(std::abs(place.y()) <= half.y());
      for (std::size_t j = 0; j < i; ++j) CHECK((place - scene.robots[j].pose.position_m).norm() > 0.18);
    }
  }
}

TEST_CASE("a swap on a circle sends everybody to another's place or the opposite point") {
  const MotionScene scene = circle_swap(22, 4.0, true);
  CHECK(scene.targets[0].targets.size() == 11);
  CHECK(scene.targets[1].targets.size() == 11);
  for (const RobotPlacement& robot : scene.robots) {
    const Target& target = scene.targets.at(static_cast<std::size_t>(robot.id.team)).targets.at(robot.id.number);
    CHECK((robot.pose.position_m + target.pose.position_m).norm() < 1e-12);
    CHECK(robot.pose.position_m.norm() == Approx(4.0));
  }
  CHECK(circle_swap(100, 10.0, false).field.length_m >= 20.0);
}

TEST_CASE("nobody is faster than the straight drive, but for the last centimetres") {
  // 4.5 m = 3² / (2 · 3) + 3² / (2 · 4) + 1.875 m at 3 m/s
  CHECK(straight_drive_s(4.5, RobotLimits{}) == Approx(1.0 + 0.75 + 0.625));
  // At 4 m/s² the last 5 cm take √(2 · 0.05 / 4) s.
  constexpr double kRest_s = 0.159;
  for (const MotionScene& scene : {defence_area(), ring(), occupied_target()}) {
    const SceneScore score = play_scene(scene, {}, "none", 1);
    for (const Arrival& arrival : score.arrivals) {
      INFO(scene.name << ", " << to_string(arrival.robot));
      if (arrival.arrived_s) CHECK(*arrival.arrived_s > arrival.straight_s - kRest_s);
    }
  }
}

TEST_CASE("there is no way around the corridor") {
  MotionScene scene = corridor();
  scene.limit_s = 10.0;
  std::erase_if(scene.robots, [](const RobotPlacement& robot) { return robot.id == RobotId{Team::yellow, 1}; });
  const SceneScore alone = play_scene(scene, {}, "none", 1);
  REQUIRE(alone.arrivals.size() == 1);
  CHECK(alone.arrivals[0].arrived_s.has_value());
  scene.add(Team::blue, Vec2::Zero());
  const SceneScore blocked = play_scene(scene, {}, "none", 1);
  CHECK(!blocked.arrivals[0].arrived_s);
  CHECK(blocked.arrivals[0].waited_m > 2.5);
}

TEST_CASE("two head-on in the corridor both arrive") {
  MotionScene scene = corridor();
  for (const auto& arrival : play_scene(scene, {}, "none", 1).arrivals) {
    INFO(to_string(arrival.robot));
    CHECK(arrival.arrived_s.has_value());
  }
}

TEST_CASE("bench swap") {
  const BenchRun bench;
  SwapOptions options;
  options.runs = 1;
  options.scenes = {"defence", "ring"};
  options.pictures = false;
  CHECK(run_swap(options, bench.run) == 0);
  CHECK(bench.rows("swap") == 2);
  CHECK(std::filesystem::file_size(bench.run.out / "swap_1.lcmlog") > 0);
  options.scenes = {"no such scene"};
  CHECK_THROWS_AS(run_swap(options, bench.run), std::invalid_argument);
}

TEST_CASE("bench motion") {
  const BenchRun bench;
  MotionOptions options;
  options.moves = 5;
  options.drives = 2;
  options.presets = {"none"};
  CHECK(run_motion(options, bench.run) == 0);
  CHECK(bench.rows("motion_free") == 4);
  CHECK(bench.rows("motion_standing") == 1);
  CHECK(bench.has_plot("motion"));
}

TEST_CASE("a dynamic drive without obstacles takes the straight line's time; obstacles go where they should") {
  DynamicScenario scenario = load_dynamic_scenario("dvg_dynamic_1");
  const std::vector<double> phases{0.1, 0.3, 0.5, 0.7, 0.9, 0.2, 0.4};
  const DynamicDrive among = drive_dynamic(scenario, phases, {}, "none", 1);
  const DynamicDrive again = drive_dynamic(scenario, phases, {}, "none", 1);
  CHECK(among.navigation_s == again.navigation_s);
  CHECK(among.crossed == again.crossed);
  CHECK(among.collisions == again.collisions);
  CHECK(among.crossed > 0);
  scenario.obstacles.clear();
  const DynamicDrive alone = drive_dynamic(scenario, {}, {}, "none", 1);
  CHECK(alone.arrived);
  CHECK(alone.collisions == 0);
  CHECK(alone.navigation_s > alone.straight_s - 0.1);
  CHECK(alone.navigation_s < 1.05 * alone.straight_s);
}

TEST_CASE("a shuttle is a robot: within its limits, at both ends in turn, at its top speed in between") {
  RobotLimits limits;
  limits.speed_max_mps = 2.5;
  const auto length_m = GENERATE(0.5, 2.0, 5.0);
  const Vec2 a{1.0, -0.5};
  const Vec2 b = a + Vec2(0.0, length_m);
  const Shuttle shuttle(a, b, limits);
  CHECK(shuttle.place(0.0, 0.0) == a);
  CHECK((shuttle.place(0.5, 0.0) - b).norm() <= 1e-9);
  CHECK((shuttle.place(1.0, 0.0) - a).norm() <= 1e-9);
  constexpr double kStep_s = 1e-3;
  double fastest_mps = 0.0;
  Vec2 last_mps = Vec2::Zero();
  for (double time_s = kStep_s; time_s < 6.0; time_s += kStep_s) {
    const Vec2 velocity = (shuttle.place(0.0, time_s) - shuttle.place(0.0, time_s - kStep_s)) / kStep_s;
    INFO(length_m << " m, at " << time_s << " s");
    REQUIRE(velocity.norm() <= 2.5 + 1e-9);
    REQUIRE((velocity - last_mps).norm() <= 4.0 * kStep_s + 1e-6);
    fastest_mps = std::max(fastest_mps, velocity.norm());
    last_mps = velocity;
  }
  const double reached_mps = std::sqrt(2.0 * length_m / (1.0 / 3.0 + 1.0 / 4.0));
  CHECK(fastest_mps == Approx(std::min(2.5, reached_mps)).epsilon(2e-3));
  CHECK(Shuttle(a, a, limits).place(0.3, 1.0) == a);
}

TEST_CASE("bench dynamic") {
  const BenchRun bench;
  DynamicOptions options;
  options.drives = 2;
  options.planners = {"tangent"};
  options.presets = {"noisy"};
  CHECK(run_dynamic(options, bench.run) == 0);
  CHECK(bench.rows("dynamic") >= 2);
  CHECK(bench.rows("dynamic_table11_noisy") >= 6);
  CHECK(bench.has_plot("dynamic_table10_noisy_1"));
  CHECK(bench.has_plot("dynamic_histogram_noisy_2"));
}

TEST_CASE("bench margins") {
  const BenchRun bench;
  MarginsOptions options;
  options.minutes = 0.05;
  options.margins_mm = {0.0, 20.0};
  CHECK(run_margins(options, bench.run) == 0);
  CHECK(bench.rows("margins") >= 8);
  CHECK(bench.has_plot("margins"));
}

TEST_CASE("bench cost") {
  const BenchRun bench;
  CostOptions options;
  options.minutes = 0.05;
  CHECK(run_cost(options, bench.run) == 0);
  CHECK(bench.rows("cost") >= 1);
}

}  // namespace
}  // namespace regista::bench
