// The rules as shapes and speeds: whom they bind, and how far.
#include "planning/game_rules.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "planning/obstacle_rules.h"

namespace regista {
namespace {

const RuleParams kParams;
constexpr double kRadius_m = 0.09;
const double kFrom_m = 0.5 + 0.0215 + kRadius_m + kParams.margin_m;  // between centres

WorldState with_ball(const Vec2& place_m) {
  WorldState world;
  world.ball = BallState{};
  world.ball->position_m = place_m;
  return world;
}

std::vector<Obstacle> shapes(Team team, const Situation& situation, const WorldState& world) {
  return rule_obstacles(team, world, situation, kParams, kRadius_m);
}

TEST_CASE("the ball is an obstacle only where the rules say so") {
  const WorldState world = with_ball({1, 2});
  const std::vector<Obstacle> ball{disc({1, 2}, kFrom_m)};
  for (const Team team : {Team::yellow, Team::blue}) {
    CHECK(shapes(team, {}, world).empty());
    CHECK(shapes(team, {SituationKind::halt, {}, {}}, world).empty());
    CHECK(shapes(team, {SituationKind::stop, {}, {}}, world) == ball);
    for (const SituationKind kick : {SituationKind::kick_off, SituationKind::free_kick, SituationKind::penalty}) {
      CHECK(shapes(team, {kick, team, {}}, world).empty());
      CHECK(shapes(team, {kick, opponent_of(team), {}}, world) == ball);
    }
  }
  CHECK(shapes(Team::yellow, {SituationKind::stop, {}, {}}, WorldState{}).empty());
}

TEST_CASE("a placement bars the line from the ball to its place for the other team") {
  const Situation placement{SituationKind::ball_placement, Team::blue, Vec2(4, 2)};
  const WorldState world = with_ball({1, 2});
  CHECK(shapes(Team::yellow, placement, world) == std::vector<Obstacle>{capsule({1, 2}, {4, 2}, kFrom_m)});
  CHECK(shapes(Team::blue, placement, world).empty());
  CHECK(shapes(Team::yellow, placement, WorldState{}) == std::vector<Obstacle>{disc({4, 2}, kFrom_m)});
  CHECK(shapes(Team::yellow, {SituationKind::ball_placement, Team::blue, {}}, world) ==
        std::vector<Obstacle>{disc({1, 2}, kFrom_m)});
}

TEST_CASE("speeds: standing at halt, slow in stop, else free") {
  CHECK(rule_speed_max({SituationKind::halt, {}, {}}, kParams) == 0.0);
  CHECK(rule_speed_max({SituationKind::stop, {}, {}}, kParams) == kParams.stop_speed_mps);
  CHECK(kParams.stop_speed_mps < 1.5);
  for (const SituationKind kind : {SituationKind::running, SituationKind::free_kick, SituationKind::ball_placement}) {
    CHECK(std::isinf(rule_speed_max({kind, Team::blue, {}}, kParams)));
  }
}

TEST_CASE("in stop and at free kicks the opponent's area grows, the own one does not") {
  const PlanningParams params;
  const FieldGeometry field = division_a();
  const Vec2 near_opponent(4.2 - 0.2 - kRadius_m, 0.0);
  const Vec2 near_own = -near_opponent;
  const auto is_free_at = [&](const Vec2& place, const Situation& situation) {
    return obstacles_for(Team::yellow, field, WorldState{}, params, situation).field.is_free(place);
  };
  CHECK(is_free_at(near_opponent, {}));
  CHECK(is_free_at(near_opponent, {SituationKind::kick_off, Team::blue, {}}));
  for (const Team team : {Team::yellow, Team::blue}) {
    CHECK_FALSE(is_free_at(near_opponent, {SituationKind::free_kick, team, {}}));
  }
  CHECK_FALSE(is_free_at(near_opponent, {SituationKind::stop, {}, {}}));
  CHECK(is_free_at(near_own, {SituationKind::stop, {}, {}}));
}

TEST_CASE("a team's obstacles are its robots' and the static ones, in that order") {
  WorldState world = with_ball({1, 2});
  world.robots.resize(2);
  world.robots[1].id.number = 1;
  world.robots[1].pose.position_m = {3, 3};
  const Situation stop{SituationKind::stop, {}, {}};
  const PlanningParams params;
  for (const Team team : {Team::yellow, Team::blue}) {
    const auto still = static_obstacles(team, division_a(), world, stop, params);
    const TeamObstacles all = obstacles_for(team, division_a(), world, params, stop);
    REQUIRE(all.field.size() == 2 + still.size());
    CHECK(all.own_area == 2 + kOwnArea);
    for (std::size_t i = 0; i < still.size(); ++i) CHECK(all.field.obstacles()[2 + i] == still[i]);
    // Without a referee, what there was before there were rules.
    CHECK(static_obstacles(team, division_a(), world, {}, params).size() + 1 == still.size());
  }
}

TEST_CASE("a ball that is nowhere is refused where it matters") {
  const WorldState world = with_ball({std::numeric_limits<double>::quiet_NaN(), 0});
  CHECK_NOTHROW(static_obstacles(Team::yellow, division_a(), world, {}, {}));
  CHECK_THROWS_WITH(static_obstacles(Team::yellow, division_a(), world, {SituationKind::stop, {}, {}}, {}),
                    Catch::Contains("ball"));
}

}  // namespace
}  // namespace regista
