#include <catch2/catch.hpp>

#include "modules/convert/message.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_geometry_convert.h"
#include "ssl_vision_wrapper.pb.h"
#include "tests/ssl/packets.h"
#include "tests/ssl/protoc.h"
#include "tests/ssl/wire.h"

using namespace regista;

namespace {

SSL_GeometryData field_of(int length_mm, int width_mm) {
  SSL_GeometryData geometry;
  SSL_GeometryFieldSize& size = *geometry.mutable_field();
  size.set_field_length(length_mm);
  size.set_field_width(width_mm);
  size.set_goal_width(1000);
  size.set_goal_depth(180);
  size.set_boundary_width(300);
  return geometry;
}

void draw_line(SSL_GeometryData& geometry, const char* name, float x_mm, float half_width_mm) {
  SSL_FieldLineSegment& line = *geometry.mutable_field()->add_field_lines();
  line.set_name(name);
  line.set_thickness(10);
  line.mutable_p1()->set_x(x_mm);
  line.mutable_p1()->set_y(-half_width_mm);
  line.mutable_p2()->set_x(x_mm);
  line.mutable_p2()->set_y(half_width_mm);
}

}  // namespace

TEST_CASE("a division A field as protoc makes it is our division A") {
  const auto packet = parse_packet<SSL_WrapperPacket>(as_bytes(encode_vision(geometry_text())));
  CHECK(to_field_geometry(packet.geometry(), false) == division_a());
  FieldGeometry turned = division_a();
  turned.yellow_on_positive_x = true;
  CHECK(to_field_geometry(packet.geometry(), true) == turned);
}

TEST_CASE("the league's geometry field numbers, written by hand") {
  const std::string size = wire::of_int(1, 9000) + wire::of_int(2, 6000) + wire::of_int(3, 900) + wire::of_int(4, 170) +
                           wire::of_int(5, 250) + wire::of_int(8, 1100) + wire::of_int(9, 2100) +
                           wire::of_int(10, 450) + wire::of_int(11, 10) + wire::of_int(12, 6000) +
                           wire::of_int(13, 160) + wire::of_float(14, 21.5F) + wire::of_float(15, 90.0F) +
                           wire::of_int(16, 350) + wire::of_int(17, 1000);
  const std::string bytes = wire::of_bytes(2, wire::of_bytes(1, size));
  const FieldGeometry field = to_field_geometry(parse_packet<SSL_WrapperPacket>(as_bytes(bytes)).geometry(), false);
  FieldGeometry wanted;
  wanted.length_m = 9.0;
  wanted.width_m = 6.0;
  wanted.goal_width_m = 0.9;
  wanted.goal_depth_m = 0.17;
  wanted.margin_touch_line_m = 0.25;
  wanted.margin_goal_line_m = 0.35;
  wanted.defence_depth_m = 1.1;
  wanted.defence_width_m = 2.1;
  wanted.centre_circle_radius_m = 0.45;
  CHECK(field == wanted);
}

TEST_CASE("without a margin of its own the goal line has the touch line's") {
  const FieldGeometry field = to_field_geometry(field_of(9000, 6000), false);
  CHECK(field.margin_goal_line_m == 0.3);
  CHECK(field.margin_touch_line_m == 0.3);
}

TEST_CASE("defence areas come from the drawn lines where they are not announced") {
  for (const auto& [name, x_mm] : {std::pair{"LeftPenaltyStretch", -4000.0F}, {"RightPenaltyStretch", 4000.0F}}) {
    CAPTURE(name);
    SSL_GeometryData geometry = field_of(10400, 7400);
    draw_line(geometry, "HalfwayLine", 0, 3700);
    draw_line(geometry, name, x_mm, 1200);
    const FieldGeometry field = to_field_geometry(geometry, false);
    CHECK(field.defence_depth_m == Approx(1.2));
    CHECK(field.defence_width_m == Approx(2.4));
  }
  SSL_GeometryData typed = field_of(10400, 7400);
  draw_line(typed, "some other name", -4200, 1000);
  typed.mutable_field()->mutable_field_lines(0)->set_type(LeftPenaltyStretch);
  CHECK(to_field_geometry(typed, false).defence_depth_m == Approx(1.0));
}

TEST_CASE("what the source leaves open is as in the division of nearer length") {
  const FieldGeometry b = to_field_geometry(field_of(9000, 6000), false);
  CHECK(b.defence_depth_m == division_b().defence_depth_m);
  CHECK(b.defence_width_m == division_b().defence_width_m);
  CHECK(b.centre_circle_radius_m == 0.5);
  const FieldGeometry a = to_field_geometry(field_of(12000, 9000), false);
  CHECK(a.defence_depth_m == division_a().defence_depth_m);
  CHECK(a.defence_width_m == division_a().defence_width_m);
}

TEST_CASE("a field that makes no sense is refused") {
  CHECK_THROWS_AS(to_field_geometry(field_of(0, 6000), false), MessageError);
  CHECK_THROWS_AS(to_field_geometry(field_of(-9000, 6000), false), MessageError);
  CHECK_THROWS_AS(to_field_geometry(field_of(9000, 2'000'000'000), false), MessageError);
  SSL_GeometryData geometry = field_of(9000, 6000);
  geometry.mutable_field()->set_boundary_width(-1);
  CHECK_THROWS_AS(to_field_geometry(geometry, false), MessageError);
  geometry = field_of(9000, 6000);
  geometry.mutable_field()->set_penalty_area_depth(4501);
  CHECK_THROWS_AS(to_field_geometry(geometry, false), MessageError);
  geometry = field_of(9000, 6000);
  geometry.mutable_field()->set_penalty_area_width(6001);
  CHECK_THROWS_AS(to_field_geometry(geometry, false), MessageError);
  geometry = field_of(9000, 6000);
  draw_line(geometry, "LeftPenaltyStretch", std::numeric_limits<float>::quiet_NaN(), 1000);
  CHECK_THROWS_AS(to_field_geometry(geometry, false), MessageError);
}
