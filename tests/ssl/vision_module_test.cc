// The vision module over real multicast, fed with packets that protoc made.
#include <catch2/catch.hpp>
#include <random>

#include "modules/convert/service.h"
#include "modules/convert/vision.h"
#include "modules/ssl/ssl_vision_module.h"
#include "tests/ssl/module_bench.h"
#include "tests/ssl/packets.h"
#include "tests/ssl/plain_udp.h"
#include "tests/ssl/protoc.h"

using namespace regista;
using namespace std::chrono_literals;

namespace {

SslVisionParams private_params() {
  SslVisionParams params;
  params.group = private_group();
  params.port = private_port();
  params.interface = "lo";
  return params;
}

struct Door : TestBus {
  SslVisionModule module{bus, private_params()};
  Queue<VisionFrame> frames{bus, channels::vision(), 100};
  Queue<FieldAnnouncement> fields{bus, channels::geometry(), 100};
  MulticastSender source{private_group(), private_port()};

  std::optional<VisionFrame> next_frame() {
    run(module, [&] { return !frames.empty(); });
    return frames.pop();
  }
  std::optional<FieldAnnouncement> next_field() {
    run(module, [&] { return !fields.empty(); });
    return fields.pop();
  }
};

}  // namespace

TEST_CASE("every camera's detection frame becomes a VISION message") {
  Door door;
  CHECK_THAT(door.module.note(), Catch::StartsWith("waiting for SSL-Vision at "));
  door.source.send(encode_vision(detection_text(0, 17)));
  door.source.send(encode_vision(detection_text(1, 900)));
  const auto first = door.next_frame();
  const auto second = door.next_frame();
  REQUIRE(first);
  REQUIRE(second);
  CHECK(first->camera == 0);
  CHECK(first->frame_number == 17);
  CHECK(second->camera == 1);
  CHECK(second->frame_number == 900);
  CHECK(first->captured == from_us(1'700'000'000'250'000));
  CHECK(first->robots.size() == 2);
  CHECK(first->balls.size() == 1);
  CHECK_THAT(door.module.note(), Catch::StartsWith("no geometry yet"));
}

TEST_CASE("a packet larger than an Ethernet frame arrives whole") {
  Door door;
  std::string text = "detection { frame_number: 1 camera_id: 0 t_capture: 1 t_sent: 1 ";
  for (int i = 0; i < 1000; ++i) {
    text += "robots_blue { confidence: 1 robot_id: " + std::to_string(i) + " x: " + std::to_string(i) +
            " y: 2 orientation: 3 pixel_x: 0 pixel_y: 0 }";
  }
  const std::string bytes = encode_vision(text + "}");
  REQUIRE(bytes.size() > 30'000);
  door.source.send(bytes);
  const auto frame = door.next_frame();
  REQUIRE(frame);
  REQUIRE(frame->robots.size() == 1000);
  CHECK(frame->robots[999].pose.position_m == Vec2(0.999, 0.002));
}

TEST_CASE("geometry is published when it comes, when it changes and every second") {
  Door door;
  door.source.send(encode_vision(geometry_text()));
  auto field = door.next_field();
  REQUIRE(field);
  CHECK(field->field == division_a());
  CHECK(field->sent == door.now);
  CHECK(door.module.note().empty());

  SECTION("the same again is not published again") {
    door.source.send(encode_vision(geometry_text()));
    REQUIRE(door.run(door.module, [&] { return door.module.reception().received == 2; }));
    CHECK(door.fields.empty());
  }
  SECTION("a change is published at once, with its packet's detection") {
    door.source.send(encode_vision(detection_text(0, 1) + geometry_text(10400, 7400)));
    field = door.next_field();
    REQUIRE(field);
    CHECK(field->field.length_m == 10.4);
    CHECK(door.next_frame());
  }
  SECTION("a silent source's field is repeated every second") {
    CHECK(door.module.due() == door.now + 1s);
    door.now += 1s;
    field = door.next_field();
    REQUIRE(field);
    CHECK(field->sent == door.now);
    CHECK(field->field == division_a());
    door.now += 500ms;
    CHECK_THAT(door.module.note(), Catch::EndsWith("is silent"));
  }
  SECTION("the teams' sides are a parameter, changed while it runs") {
    Queue<Reply> replies(door.bus, channels::reply(), 10);
    door.bus.publish(channels::request(),
                     Request{door.now, 1, "ssl-vision", "param.set", "yellow_on_positive_x", "true"});
    REQUIRE(door.run(door.module, [&] { return !replies.empty(); }));
    CHECK(replies.pop()->accepted);
    field = door.next_field();
    REQUIRE(field);
    CHECK(field->field.yellow_on_positive_x);
  }
}

TEST_CASE("the group is changed while it runs, a bad one is refused and the old one stays") {
  Door door;
  Queue<Reply> replies(door.bus, channels::reply(), 10);
  const std::string port = std::to_string(private_port() + 1);
  door.bus.publish(channels::request(), Request{door.now, 1, "ssl-vision", "param.set", "group", "10.0.0.1"});
  door.bus.publish(channels::request(), Request{door.now, 2, "ssl-vision", "param.set", "port", port});
  REQUIRE(door.run(door.module, [&] { return !replies.empty(); }));
  CHECK_FALSE(replies.pop()->accepted);
  CHECK(replies.pop()->accepted);
  MulticastSender moved(private_group(), static_cast<std::uint16_t>(private_port() + 1));
  door.source.send(encode_vision(detection_text(0, 1)));
  moved.send(encode_vision(detection_text(0, 2)));
  const auto frame = door.next_frame();
  REQUIRE(frame);
  CHECK(frame->frame_number == 2);
}

TEST_CASE("robots without number or heading are counted and reported") {
  Door door;
  door.source.send(encode_vision(geometry_text() + R"(detection { frame_number: 1 camera_id: 0 t_capture: 1 t_sent: 1
    robots_blue { confidence: 1 x: 0 y: 0 orientation: 3 pixel_x: 0 pixel_y: 0 }
    robots_blue { confidence: 1 robot_id: 1 x: 0 y: 0 pixel_x: 0 pixel_y: 0 } })"));
  const auto frame = door.next_frame();
  REQUIRE(frame);
  CHECK(frame->robots.empty());
  CHECK(door.module.robots_skipped() == 2);
  CHECK(door.module.note() == "2 robots seen without number or heading");
}

TEST_CASE("malformed packets are refused, counted and leave the module running") {
  const std::string whole = encode_vision(detection_text(0, 1));
  std::mt19937_64 random(7);
  std::string noise(300, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  const std::vector<std::pair<std::string, std::string>> cases{
      {"not a well-formed", whole.substr(0, whole.size() / 2)},
      {"not a well-formed", noise},
      {"neither detection nor geometry", ""},
      {"neither detection nor geometry", encode_vision("source: SSL_SOURCE_GRSIM")},
      {"x_m", encode_vision("detection { frame_number: 1 camera_id: 0 t_capture: 1 t_sent: 1 "
                            "balls { confidence: 1 x: nan y: 0 pixel_x: 0 pixel_y: 0 } }")},
      {"beyond ±1000", encode_vision("detection { frame_number: 1 camera_id: 0 t_capture: 1 t_sent: 1 "
                                     "balls { confidence: 1 x: 1e9 y: 0 pixel_x: 0 pixel_y: 0 } }")},
      {"t_capture", encode_vision("detection { frame_number: 1 camera_id: 0 t_capture: nan t_sent: 1 }")},
      {"detection.t_sent", encode_vision("detection { frame_number: 1 camera_id: 0 t_capture: 1 }")},
      {"geometry.field", encode_vision("geometry { }")},
      {"field_length", encode_vision(geometry_text(-1))},
      // The good detection beside a bad geometry is not published either.
      {"field_width", encode_vision(detection_text(0, 1) + geometry_text(12000, 0))},
  };
  Door door;
  std::int64_t refused = 0;
  for (const auto& [why, bytes] : cases) {
    CAPTURE(why);
    door.source.send(bytes);
    ++refused;
    REQUIRE(door.run(door.module, [&] { return door.module.reception().refused == refused; }));
    CHECK_THAT(door.module.reception().last_refusal, Catch::Contains(why));
    CHECK(door.frames.empty());
    CHECK(door.fields.empty());
  }
  CHECK(door.bus.reception().refused == refused);
  door.source.send(encode_vision(detection_text(0, 99)));
  const auto frame = door.next_frame();
  REQUIRE(frame);
  CHECK(frame->frame_number == 99);
}

TEST_CASE("a network that is not there is said in one line") {
  TestBus here;
  SslVisionParams params = private_params();
  params.interface = "no-such-card";
  CHECK_THROWS_WITH(SslVisionModule(here.bus, params),
                    Catch::Contains("'no-such-card', there are: ") && Catch::Contains("lo"));
  params = private_params();
  params.group = "192.168.0.1";
  CHECK_THROWS_WITH(SslVisionModule(here.bus, params), Catch::Contains("no IPv4 multicast address"));
}
