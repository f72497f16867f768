// What a picture drawn without display shows, at the pixels where it must.
#include "modules/viewer/offscreen.h"

#include <catch2/catch.hpp>

#include "fake_scene.h"
#include "modules/viewer/scene_drawing.h"
#include "picture.h"
#include "tests/support/temporary_folder.h"

namespace regista {
namespace {

constexpr int kWidth_px = 1280;
constexpr int kHeight_px = 800;

Picture drawn(const ViewerScene& scene, int width_px = kWidth_px, int height_px = kHeight_px) {
  const TemporaryFolder scratch;
  const std::string file = scratch.path("picture.png");
  write_picture(scene, file, width_px, height_px);
  return Picture(file);
}

bool is_grass(Color color) { return alike(color, palette::kGrass, 12) || alike(color, palette::kGrassBand, 12); }

}  // namespace

TEST_CASE("a picture shows robots, ball, targets, paths and graphs where they are") {
  const ViewerScene scene = fake_scene();
  const Picture picture = drawn(scene);
  const View view = fitted_view(scene.field, kWidth_px, kHeight_px);
  REQUIRE(picture.width() == kWidth_px);
  REQUIRE(picture.height() == kHeight_px);
  CHECK(alike(picture.at(pixel_of(view, {5.9, 4.4})), palette::kGrass, 12));
  CHECK(alike(picture.at(pixel_of(view, {6.3, 4.6})), palette::kStrip, 12));
  CHECK(alike(picture.at(5, 400), palette::kSurroundings, 12));
  for (const RobotState& robot : scene.world.robots) {
    INFO(to_string(robot.id));
    const Vec2 back = robot.pose.position_m - rotated({0.05, 0.0}, robot.pose.heading_rad);
    CHECK(alike(picture.at(pixel_of(view, back)), color_of(robot.id.team), 60));
  }
  CHECK(picture.count_near(palette::kBall, pixel_of(view, scene.world.ball->position_m), 3) > 10);
  for (const Team team : {Team::yellow, Team::blue}) {
    const TeamScene& play = scene.of(team);
    for (const Target& target : play.targets->targets) {
      CHECK(picture.count_near(color_of(team), pixel_of(view, target.pose.position_m), 10, 60) > 30);
    }
    for (const auto& [number, plan] : play.plans) {
      CHECK(picture.count_near(color_of(team), pixel_of(view, plan.plan.path[1]), 3, 60) > 4);
    }
  }
  ViewerScene without_graphs = scene;
  without_graphs.teams[0].graph.reset();
  without_graphs.teams[1].graph.reset();
  CHECK(picture != drawn(without_graphs));
  CHECK(picture == drawn(scene));
}

TEST_CASE("a shared graph shows its free edges faintly and leaves the blocked out") {
  ViewerScene scene;
  GraphPicture graph;
  graph.team = Team::yellow;
  graph.nodes = {{1.0, 1.0}, {4.0, 1.0}, {1.0, 3.0}, {4.0, 3.0}};
  graph.edges = {{0, 1, false}, {2, 3, true}};
  scene.of(Team::yellow).graph = graph;
  const Picture picture = drawn(scene);
  const View view = fitted_view(scene.field, kWidth_px, kHeight_px);
  const auto reddest = [&](double y) {
    int red = 0;
    for (int shift = -2; shift <= 2; ++shift) {
      red = std::max<int>(red, picture.at(pixel_of(view, {2.5, y}) + Vec2(0, shift)).red);
    }
    return red;
  };
  CHECK(reddest(1.0) > palette::kGrassBand.red + 20);
  CHECK(reddest(1.0) < palette::kYellow.red - 60);
  CHECK(reddest(3.0) < palette::kGrassBand.red + 10);
}

TEST_CASE("an empty scene shows a field with its lines and both goals") {
  const ViewerScene scene;
  const Picture picture = drawn(scene);
  const View view = fitted_view(scene.field, kWidth_px, kHeight_px);
  CHECK(is_grass(picture.at(pixel_of(view, {1.5, 1.5}))));
  CHECK(picture.count_near(palette::kFieldLine, pixel_of(view, {0.0, 3.0}), 2, 80) > 3);
  CHECK(picture.count_near(palette::kFieldLine, pixel_of(view, {-4.2, 1.0}), 2, 80) > 3);
  CHECK(picture.count_near(palette::kYellow, pixel_of(view, {-6.18, 0.0}), 3, 60) > 5);
  CHECK(picture.count_near(palette::kBlue, pixel_of(view, {6.18, 0.0}), 3, 60) > 5);
  int grass = 0;
  for (int y = 0; y < kHeight_px; ++y) {
    for (int x = 0; x < kWidth_px; ++x) grass += is_grass(picture.at(x, y)) ? 1 : 0;
  }
  CHECK(grass > kWidth_px * kHeight_px / 2);
  CHECK(picture.count(palette::kBall, 10) == 0);
}

TEST_CASE("robots move in the picture as they move on the field") {
  ViewerScene scene;
  scene.world.robots = {fake_robot(Team::blue, 7)};
  const Picture before = drawn(scene);
  const Vec2 from = scene.world.robots[0].pose.position_m;
  scene.world.robots[0].pose.position_m += Vec2(1.0, 0.5);
  const Picture after = drawn(scene);
  const View view = fitted_view(scene.field, kWidth_px, kHeight_px);
  CHECK(before.count_near(palette::kBlue, pixel_of(view, from), 5) > 20);
  CHECK(after.count_near(palette::kBlue, pixel_of(view, from), 5) == 0);
  CHECK(after.count_near(palette::kBlue, pixel_of(view, from + Vec2(1.0, 0.5)), 5) > 20);
}

TEST_CASE("other sizes and fields fit too") {
  CHECK(drawn(fake_scene(), 400, 900).height() == 900);
  ViewerScene scene;
  scene.field = division_b();
  const Picture picture = drawn(scene, 640, 400);
  const View view = fitted_view(scene.field, 640, 400);
  CHECK(is_grass(picture.at(pixel_of(view, {4.3, 2.8}))));
  CHECK(alike(picture.at(pixel_of(view, {4.65, 3.15})), palette::kStrip, 12));
}

TEST_CASE("a picture that cannot be written says so in one line") {
  const TemporaryFolder scratch;
  try {
    write_picture({}, scratch.path("no/such/folder/x.png"), 320, 200);
    FAIL("it was written");
  } catch (const PictureError& error) {
    const std::string text = error.what();
    CHECK(text.find("cannot write the picture '") == 0);
    CHECK(text.find('\n') == std::string::npos);
  }
}

}  // namespace regista
