// Counting changes of side from the messages of a bus.
#include "modules/lockstep/side_changes.h"

#include <catch2/catch.hpp>

#include "tests/modules/loop_fixture.h"

using namespace regista;
using namespace regista::loop_test;

namespace {

/// Two robots on a bus, one planning past the other, 100 frames a second.
class Scene {
 public:
  Scene() : bus_("memq://", [] { return Time{}; }), changes_(bus_, Team::yellow, {}) {
    bus_.publish(channels::geometry(), FieldAnnouncement{Time{}, division_a()});
    world_.robots.resize(2);
    world_.robots[0].id = {Team::yellow, 0};
    world_.robots[0].pose.position_m = {-2, 0};
    world_.robots[1].id = {Team::blue, 0};
    plan_.robot = {Team::yellow, 0};
    plan_.target.pose.position_m = {2, 0};
  }

  /// A world state and the plan for it, which passes the other robot on that side.
  void pass_by(double y_m) {
    ++world_.sequence;
    world_.captured += from_seconds(kPeriod_s);
    plan_.world_sequence = world_.sequence;
    plan_.captured = world_.captured;
    plan_.plan = {PlanStatus::ok, false, false, {{-2, 0}, {0, y_m}, {2, 0}}, 4.2, ""};
    bus_.publish(channels::world_state(), world_);
    bus_.publish(channels::plan(plan_.robot), plan_);
    while (bus_.handle(Duration::zero())) {
    }
  }
  void lose_frame() { ++world_.sequence; }
  void new_target(double x_m) { plan_.target.pose.position_m.x() = x_m; }
  SideChangeRate rate() const { return changes_.rate(); }

 private:
  Bus bus_;
  SideChanges changes_;
  WorldState world_;
  RobotPlan plan_;
};

constexpr double kPerMinute = 60.0 / kPeriod_s;  // of frames

}  // namespace

TEST_CASE("changes of side are counted per minute of plans that can be compared") {
  Scene scene;
  CHECK(scene.rate().all == 0.0);
  for (const double y_m : {1.0, 1.1, -1.0, -1.0, 1.0}) scene.pass_by(y_m);
  CHECK(scene.rate().all == Approx(2.0 / 4.0 * kPerMinute));
  CHECK(scene.rate().quick == Approx(1.0 / 4.0 * kPerMinute));
  for (int frame = 0; frame < 30; ++frame) scene.pass_by(1.0);
  scene.pass_by(-1.0);
  CHECK(scene.rate().all == Approx(3.0 / 35.0 * kPerMinute));
  CHECK(scene.rate().quick == Approx(1.0 / 35.0 * kPerMinute));
  scene.new_target(1.9);
  scene.pass_by(1.0);
  scene.lose_frame();
  scene.pass_by(-1.0);
  CHECK(scene.rate().all == Approx(3.0 / 35.0 * kPerMinute));
}

TEST_CASE("in the main job robots change their minds less often when they need a gain") {
  const auto quick = [](const std::string& gain) {
    const RunSummary summary =
        run_scenario(crossing({"scenario.duration_s=60", "planner.side_change_gain=" + gain}), {}, no_time);
    return summary.side_changes_yellow.quick + summary.side_changes_blue.quick;
  };
  const double without = quick("0");
  CHECK(without > 30.0);
  CHECK(quick("0.2") < 0.9 * without);
}
