// Occluders may miss what blocks a leg, but never claim what does not: else an exact search would drop free legs.
#include "planning/graph/occluders.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "planning/clearance.h"
#include "planning/uniform.h"

namespace regista::graph {
namespace {

TEST_CASE("what occluders say is blocked is blocked by one of the last four obstacles") {
  std::mt19937_64 random(71);
  int blocked = 0;
  int claimed = 0;
  for (int round = 0; round < 2000; ++round) {
    // Far from the origin single precision is coarse.
    const Vec2 middle = (round % 2 == 0 ? 0.0 : 300.0) * Vec2(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
    const auto point = [&] { return Vec2(middle + Vec2(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0))); };
    Occluders occluders;
    std::vector<Obstacle> last;
    for (int i = 0; i < 6; ++i) {
      const Vec2 a = point();
      const Vec2 b = point();
      const double radius_m = uniform(random, 0.05, 0.4);
      const Obstacle obstacle = i % 3 == 0   ? disc(a, radius_m)
                                : i % 3 == 1 ? capsule(a, b, radius_m)
                                             : rounded_rectangle(a.cwiseMin(b), a.cwiseMax(b), radius_m);
      occluders.add(obstacle);
      last.push_back(obstacle);
      if (last.size() > 4) last.erase(last.begin());
    }
    for (int i = 0; i < 20; ++i) {
      const Vec2 from = point();
      const Vec2 to = point();
      const Vec2 along = (to - from).normalized();
      const bool is_blocked =
          std::any_of(last.begin(), last.end(), [&](const Obstacle& one) { return !is_free(from, to, one); });
      const bool claims = occluders.surely_block({from, to, along});
      INFO("leg " << i << " of round " << round << " of seed 71");
      if (claims) CHECK(is_blocked);
      blocked += is_blocked ? 1 : 0;
      claimed += claims ? 1 : 0;
    }
  }
  CHECK(claimed > blocked / 3);
  const Vec2 from(0, 0), to(1, 0);
  CHECK_FALSE(Occluders().surely_block({from, to, to}));
}

}  // namespace
}  // namespace regista::graph
