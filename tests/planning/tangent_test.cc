// The exact planner against its judge (tests/planning/tangent_court.h) in random worlds: varied, a match's, crowded.
#include <catch2/catch.hpp>

#include "tests/planning/tangent_court.h"
#include "tests/support/planning_worlds.h"
#include "tests/support/share.h"
#include "tests/support/varied_worlds.h"

namespace regista::testing {

TEST_CASE("in varied worlds tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(10000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = varied_field(random, random() % (world % 4 == 0 ? 26 : 11));
    CAPTURE(world);
    REQUIRE(court.fault(field, random_free_request(random, field)) == "");
  }
  CAPTURE(court.worlds(), court.bent(), court.unreachable());
  CHECK(court.worlds() > share_of(9900));
  CHECK(court.bent() > share_of(2500));
  CHECK(court.unreachable() > share_of(200));
  CHECK(court.known_free() > share_of(5000));
}

TEST_CASE("on fields of a match's size tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(1000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = random_field(random, static_cast<std::size_t>(world % 50));
    CAPTURE(world);
    REQUIRE(court.fault(field, random_free_request(random, field)) == "");
  }
  CHECK(court.bent() > share_of(400));
}

TEST_CASE("among hundreds of overlapping obstacles tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < 16; ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = random_field(random, world < 12 ? 200 : 400);
    CAPTURE(world);
    REQUIRE(court.fault(field, random_free_request(random, field)) == "");
  }
  CHECK(court.bent() > 5);
}

}  // namespace regista::testing
