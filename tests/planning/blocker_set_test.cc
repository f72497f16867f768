// Few or many, the answer is that of asking all obstacles but the two that are touched.
#include "planning/graph/blocker_set.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "tests/support/planning_worlds.h"
#include "tests/support/varied_worlds.h"

namespace regista::graph {

TEST_CASE("a motion is clear of a set when it is free of each of them") {
  std::mt19937_64 random(73);
  BlockerSet set;
  int blocked = 0;
  int clear = 0;
  for (int world = 0; world < 2000; ++world) {
    const ObstacleField field = testing::varied_field(random, 1 + random() % 12);
    set.clear(field.size());
    Occluders occluders;
    for (ObstacleIndex i = 0; i < field.size(); ++i) {
      CHECK_FALSE(set.contains(i));
      set.add(field, i);
      CHECK(set.contains(i));
    }
    CHECK(set.size() == field.size());
    for (int motion = 0; motion < 5; ++motion) {
      const PlanRequest request = testing::random_free_request(random, field);
      const Vec2 along = (request.goal - request.start).normalized();
      const bool touches = motion % 2 == 0;
      const auto from = touches ? static_cast<std::uint32_t>(random() % field.size()) : BlockerSet::kNone;
      const auto to = touches ? static_cast<std::uint32_t>(random() % field.size()) : BlockerSet::kNone;
      bool is_clear = true;
      for (std::uint32_t slot = 0; slot < field.size(); ++slot) {
        if (slot == from || slot == to) continue;
        is_clear = is_clear && is_free(request.start, request.goal, field.obstacles()[set.list()[slot]]);
      }
      // Occluders are of motions that touch none of them, as legs from one place are.
      Occluders fresh;
      Occluders& known = touches ? fresh : occluders;
      INFO("motion " << motion << " of world " << world << " of seed 73");
      CHECK(set.are_clear_of(field, {request.start, request.goal, along}, from, to, known) == is_clear);
      (is_clear ? clear : blocked) += 1;
    }
  }
  CHECK(blocked > 1000);
  CHECK(clear > 1000);
}

}  // namespace regista::graph
