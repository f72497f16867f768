// The shapes and the layout, without OpenGL.
#include <catch2/catch.hpp>
#include <random>

#include "fake_scene.h"
#include "modules/viewer/scene_drawing.h"
#include "modules/viewer/view.h"

namespace regista {
namespace {

double area_of(const Drawing& drawing) {
  double area = 0.0;
  for (const Triangle& triangle : drawing) {
    const auto point = [&](std::size_t i) { return Vec2(triangle.corners[i][0], triangle.corners[i][1]); };
    area += std::abs(cross(point(1) - point(0), point(2) - point(0))) / 2;
  }
  return area;
}

double uniform(std::mt19937_64& bits, double low, double high) {
  return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
}

bool has_color(const Drawing& drawing, Color color) {
  return std::any_of(drawing.begin(), drawing.end(), [&](const Triangle& t) { return t.color == color; });
}

}  // namespace

TEST_CASE("shapes cover the area they name") {
  constexpr Paint kPaint{0.1, {1, 2, 3}};
  Drawing disc, ring, segment, rectangle, point;
  add_disc(disc, {1.0, -2.0}, 0.5, kPaint);
  add_ring(ring, {1.0, -2.0}, 0.5, 0.1, kPaint);
  add_segment(segment, {0.0, 0.0}, {3.0, 4.0}, 0.2, kPaint);
  add_rectangle(rectangle, {-1.0, -2.0}, {2.0, 3.0}, kPaint);
  add_segment(point, {1.0, 1.0}, {1.0, 1.0}, 0.2, kPaint);
  CHECK(area_of(disc) == Approx(std::numbers::pi * 0.25).epsilon(0.01));
  CHECK(area_of(ring) == Approx(2 * std::numbers::pi * 0.5 * 0.1).epsilon(0.01));
  CHECK(area_of(segment) == Approx(5.0 * 0.2));
  CHECK(area_of(rectangle) == Approx(15.0));
  CHECK(point.empty());
}

TEST_CASE("every digit looks different") {
  std::vector<Drawing> digits(10);
  for (unsigned digit = 0; digit < 10; ++digit) {
    add_number(digits[digit], digit, Vec2::Zero(), 1.0, 0.1, {});
    for (unsigned other = 0; other < digit; ++other) CHECK(digits[digit] != digits[other]);
    for (const Triangle& triangle : digits[digit]) {
      for (const auto& corner : triangle.corners) {
        CHECK(std::abs(corner[0]) < 0.36F);
        CHECK(std::abs(corner[1]) < 0.56F);
      }
    }
  }
}

TEST_CASE("the view shows the whole field with its strip, whatever the picture's shape") {
  std::mt19937_64 bits(17);
  for (int i = 0; i < 1000; ++i) {
    FieldGeometry field;
    field.length_m = uniform(bits, 2.0, 200.0);
    field.width_m = uniform(bits, 2.0, 200.0);
    const int width_px = 100 + static_cast<int>(bits() % 3000);
    const int height_px = 100 + static_cast<int>(bits() % 3000);
    INFO(field.length_m << " x " << field.width_m << " m in " << width_px << " x " << height_px << " px");
    const View view = fitted_view(field, width_px, height_px);
    const Vec2 half = half_extent(field, 0.0);
    const Vec2 top_left = pixel_of(view, {-half.x(), half.y()});
    const Vec2 bottom_right = pixel_of(view, {half.x(), -half.y()});
    CHECK(top_left.x() > 0.0);
    CHECK(top_left.y() > 0.0);
    CHECK(bottom_right.x() < width_px);
    CHECK(bottom_right.y() < height_px);
    CHECK(pixel_of(view, view.centre_m).isApprox(Vec2(width_px / 2.0, height_px / 2.0)));
  }
}

TEST_CASE("what a plan that failed and an edge without node look like") {
  ViewerScene scene = fake_scene();
  CHECK(!has_color(draw_play(scene), palette::kWarning));
  scene.of(Team::blue).plans.begin()->second.plan.status = PlanStatus::not_found;
  CHECK(has_color(draw_play(scene), palette::kWarning));

  scene = fake_scene();
  const std::size_t triangles = draw_play(scene).size();
  scene.of(Team::blue).graph->edges.push_back({0, 100'000, false});
  CHECK(draw_play(scene).size() == triangles);
  scene.of(Team::blue).graph->edges.push_back({0, 1, false});
  CHECK(draw_play(scene).size() > triangles);
}

TEST_CASE("the text says planner, planning times, robots and time") {
  ViewerScene scene = fake_scene();
  const auto lines = team_lines(scene);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].text ==
        "yellow  visibility_sampling   planning p50 / max: robot 0.012 / 0.087  team 0.123 / 0.870 ms");
  CHECK(lines[1].color == palette::kBlue);
  scene.notice = "no WORLD_STATE for 3 s";
  CHECK(state_lines(scene)[0].text == "11 : 11 robots   12.34 s");
  CHECK(state_lines(scene)[1].text == "no WORLD_STATE for 3 s");
}

}  // namespace regista
