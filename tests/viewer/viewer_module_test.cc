// How messages become a scene, and when a picture is due: over memq://, with a clock of the test's.
#include <catch2/catch.hpp>

#include "fake_scene.h"
#include "modules/viewer/snapshot.h"
#include "publish_scene.h"

namespace regista {
namespace {

struct Fixture {
  Time now = from_us(5'000'000);
  Bus bus{"memq://", [this] { return now; }};
  std::vector<ViewerScene> seen;
  ViewerModule module{bus, [this](const ViewerScene& scene) { seen.push_back(scene); }};

  void publish(const ViewerScene& scene) {
    publish_scene(bus, scene);
    while (bus.handle(Duration::zero())) {
    }
    if (module.ready()) module.tick(now);
  }
};

}  // namespace

TEST_CASE("what is published is what is shown") {
  Fixture f;
  CHECK(f.module.note() == "waiting for WORLD_STATE");
  CHECK(!f.module.heard());
  CHECK(!f.module.ready());
  const ViewerScene published = fake_scene();
  f.publish(published);
  CHECK(f.module.complete());
  CHECK(!f.module.ready());
  const ViewerScene shown = f.module.scene();
  CHECK(shown.field == published.field);
  CHECK(shown.world == published.world);
  for (const Team team : {Team::yellow, Team::blue}) {
    CHECK(shown.of(team).targets == published.of(team).targets);
    CHECK(shown.of(team).plans == published.of(team).plans);
    CHECK(shown.of(team).graph == published.of(team).graph);
    CHECK(shown.of(team).planning_team == DurationSummary{870'000, 870'000});
    CHECK(shown.of(team).planning_robot == DurationSummary{12'300, 87'000});
  }
  CHECK(shown.notice.empty());
}

TEST_CASE("every world state is handed to the recorder, in order") {
  Fixture f;
  ViewerScene scene = fake_scene();
  for (int i = 1; i <= 5; ++i) {
    scene.world.sequence = static_cast<std::uint64_t>(i);
    publish_scene(f.bus, scene);
  }
  f.publish(scene);
  REQUIRE(f.seen.size() == 6);
  for (std::size_t i = 0; i < 5; ++i) CHECK(f.seen[i].world.sequence == i + 1);
}

TEST_CASE("plans of a planner that died leave the picture, and silence is said") {
  Fixture f;
  ViewerScene scene = fake_scene();
  f.publish(scene);
  scene.world.captured += std::chrono::seconds(2);
  scene.teams = {};
  f.publish(scene);
  CHECK(f.module.scene().of(Team::yellow).plans.empty());
  CHECK(!f.module.scene().of(Team::yellow).graph);
  CHECK(f.module.scene().of(Team::yellow).targets);
  CHECK(!f.module.complete());
  CHECK(f.module.note().empty());
  f.now += std::chrono::seconds(3);
  CHECK(f.module.note() == "no WORLD_STATE for 3 s");
}

TEST_CASE("the picture's clock begins with the first world state and anew with a new run") {
  Fixture f;
  ViewerScene scene = fake_scene();
  f.publish(scene);
  scene.world.captured += std::chrono::seconds(9);
  f.publish(scene);
  CHECK(f.module.scene().world.captured - f.module.scene().began == std::chrono::seconds(9));
  scene.world.captured = from_us(1000);
  f.publish(scene);
  CHECK(f.module.scene().began == from_us(1000));
}

TEST_CASE("a malformed message is counted and changes nothing") {
  Fixture f;
  f.publish(fake_scene());
  const ViewerScene before = f.module.scene();
  const std::vector<std::uint8_t> garbage(200, 0x5A);
  for (const char* channel : {"GEOMETRY", "WORLD_STATE", "TARGETS.Y", "PLAN.B3", "GRAPH.B", "TIMING.planner.Y"}) {
    f.bus.publish_raw(channel, garbage);
  }
  while (f.bus.handle(Duration::zero())) {
  }
  CHECK(f.bus.reception().refused == 6);
  CHECK(f.module.scene() == before);
}

TEST_CASE("the middle and the largest of the latest durations") {
  DurationWindow window(3);
  CHECK(!window.summary());
  window.add(900);
  CHECK(window.summary() == DurationSummary{900, 900});
  for (const std::int64_t duration : {30, 10, 20}) window.add(duration);
  CHECK(window.summary() == DurationSummary{20, 30});
}

TEST_CASE("when a picture is due") {
  const Time begin = from_us(77);
  const auto at = [&](double seconds) { return begin + from_seconds(seconds); };
  SECTION("at a given time after the first message") {
    SnapshotTrigger trigger(1.5);
    CHECK(!trigger.due(false, false, at(0.0)));
    CHECK(!trigger.due(true, true, at(10.0)));
    CHECK(!trigger.due(true, true, at(11.4)));
    CHECK(trigger.due(true, false, at(11.5)));
  }
  SECTION("else a moment after all has come in") {
    SnapshotTrigger trigger(std::nullopt);
    CHECK(!trigger.due(true, false, at(0.0)));
    CHECK(!trigger.due(true, true, at(0.5)));
    CHECK(!trigger.due(true, true, at(0.7)));
    CHECK(trigger.due(true, true, at(0.8)));
  }
  SECTION("or after two seconds with what is there") {
    SnapshotTrigger trigger(std::nullopt);
    CHECK(!trigger.due(true, false, at(0.0)));
    CHECK(!trigger.due(true, false, at(1.9)));
    CHECK(trigger.due(true, false, at(2.0)));
  }
}

TEST_CASE("a log is played at full speed unless a speed is named") {
  CHECK(at_full_speed("file:///a/b.log") == "file:///a/b.log?speed=0");
  CHECK(at_full_speed("file:///a/b.log?start_timestamp=5") == "file:///a/b.log?start_timestamp=5&speed=0");
  CHECK(at_full_speed("file:///a/b.log?speed=2") == "file:///a/b.log?speed=2");
  CHECK(at_full_speed("udpm://239.255.76.67:7667?ttl=0") == "udpm://239.255.76.67:7667?ttl=0");
}

}  // namespace regista
