#include "modules/bench/motion/motion_scene.h"

#include <cmath>
#include <numbers>

namespace regista::bench {
namespace {

constexpr double kBody_m = 0.18;        // a robot's width
constexpr double kWallPitch_m = 0.185;  // between the centres of robots that form a wall: nearly touching

Vec2 on_circle(double radius_m, double turns) {
  return {radius_m * std::cos(2.0 * std::numbers::pi * turns), radius_m * std::sin(2.0 * std::numbers::pi * turns)};
}

void add_wall(MotionScene& scene, const Vec2& from, const Vec2& to) {
  const auto count = static_cast<int>(std::floor((to - from).norm() / kWallPitch_m));
  for (int i = 0; i <= count; ++i) scene.add(Team::blue, from + (to - from).normalized() * (i * kWallPitch_m));
}

}  // namespace

MotionScene::MotionScene(std::string scene_name) : name(std::move(scene_name)) {
  for (const Team team : {Team::yellow, Team::blue}) {
    targets.at(static_cast<std::size_t>(team)).team = team;
    targets.at(static_cast<std::size_t>(team)).sequence = 1;
  }
}

void MotionScene::add(Team team, const Vec2& from, const Vec2& to) {
  Targets& all = targets.at(static_cast<std::size_t>(team));
  const auto number = static_cast<std::uint16_t>(all.targets.size());
  robots.push_back({{team, number}, {from, 0.0}});
  all.targets.push_back({.robot = number, .pose = {to, 0.0}});
}

MotionScene circle_swap(std::size_t robots, double radius_m, bool two_teams) {
  MotionScene scene("circle of " + std::to_string(robots) + (two_teams ? ", two teams" : ", one team"));
  scene.field.length_m = std::max(scene.field.length_m, 2.0 * (radius_m + scene.field.defence_depth_m + kBody_m));
  scene.field.width_m = std::max(scene.field.width_m, 2.0 * (radius_m + kBody_m));
  for (std::size_t i = 0; i < robots; ++i) {
    const Vec2 from = on_circle(radius_m, static_cast<double>(i) / static_cast<double>(robots));
    scene.add(two_teams && i % 2 == 1 ? Team::blue : Team::yellow, from, -from);
  }
  if (two_teams) scene.drivers = {SceneDriver::system, SceneDriver::system};
  scene.limit_s = 60.0;
  return scene;
}

MotionScene corridor() {
  MotionScene scene("corridor, head on");
  scene.field.length_m = 8.0;
  scene.field.width_m = 3.0;
  scene.field.defence_depth_m = 0.5;
  scene.field.defence_width_m = 1.0;
  scene.field.goal_width_m = 0.6;
  constexpr double kHalfLength_m = 0.75;
  const double side_m = 1.5 * kBody_m / 2.0 + kBody_m / 2.0;
  const double touch_m = half_extent(scene.field, kBody_m / 2.0).y();
  for (const double y : {-1.0, 1.0}) {
    add_wall(scene, {-kHalfLength_m, y * side_m}, {kHalfLength_m, y * side_m});
    add_wall(scene, {0.0, y * (side_m + kWallPitch_m)}, {0.0, y * touch_m});
  }
  scene.add(Team::yellow, {-2.5, 0.0}, {2.5, 0.0});
  scene.add(Team::yellow, {2.5, 0.0}, {-2.5, 0.0});
  return scene;
}

MotionScene ring() {
  MotionScene scene("in a ring of team-mates");
  constexpr int kMates = 8;
  constexpr double kRadius_m = 0.3;  // the gaps, 5 cm, let nobody through
  constexpr double kWay_m = 3.0;
  for (int i = 0; i < kMates; ++i) {
    const double turns = static_cast<double>(i) / kMates;
    scene.add(Team::yellow, on_circle(kRadius_m, turns), on_circle(kRadius_m + kWay_m, turns));
  }
  scene.add(Team::yellow, Vec2::Zero(), on_circle(kWay_m, 0.5 / kMates));
  return scene;
}

MotionScene defence_area() {
  MotionScene scene("out of a defence area");
  scene.add(Team::yellow, {(scene.field.length_m - scene.field.defence_depth_m) / 2.0, 0.0}, Vec2::Zero());
  return scene;
}

MotionScene occupied_target() {
  MotionScene scene("target occupied");
  scene.add(Team::yellow, {-3.0, 0.0}, {2.0, 1.0});
  scene.add(Team::blue, {2.0, 1.0});
  scene.limit_s = 10.0;
  return scene;
}

MotionScene pinned() {
  MotionScene scene("pinned by a chaser");
  scene.drivers = {SceneDriver::system, SceneDriver::chaser};
  constexpr double kTouching_m = 0.2;
  const double boards_m = half_extent(scene.field, kBody_m / 2.0).y();
  scene.add(Team::yellow, {-3.0, -boards_m}, {-3.0, 3.0});
  scene.add(Team::blue, {-3.0, kTouching_m - boards_m});
  return scene;
}

std::vector<MotionScene> swap_scenes() {
  return {circle_swap(11, 4.0, false),
          circle_swap(22, 4.0, false),
          circle_swap(22, 4.0, true),
          circle_swap(100, 10.0, false),
          corridor(),
          ring(),
          defence_area(),
          occupied_target(),
          pinned()};
}

}  // namespace regista::bench
