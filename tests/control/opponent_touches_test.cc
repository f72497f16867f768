// Touches foreseen between opponents, against dense sampling and the laws of a collision.
#include "control/safety/opponent_touches.h"

#include <catch2/catch.hpp>

#include "control/safety/motion.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;

TEST_CASE("a foreseen touch is the first; if for both, it keeps the momentum and leaves no speed towards each other") {
  Dice dice(53);
  int touched = 0;
  for (int i = 0; i < 500; ++i) {
    const std::vector<Opponent> all{{dice.point(1, 1), dice.point(2, 2), Vec2::Zero()},
                                    {dice.point(1, 1), dice.point(2, 2), Vec2::Zero()},
                                    {dice.point(1, 1), dice.point(2, 2), Vec2::Zero()}};
    std::vector<Touch> touches;
    foresee_touches(all, 0.18, 0.6, touches);
    INFO("three of round " << i << " of seed 53");
    for (std::size_t a = 0; a < all.size(); ++a) {
      double first_s = kNever;
      for (std::size_t b = 0; b < all.size(); ++b) {
        if (b == a) continue;
        const Vec2 apart = all[b].position_m - all[a].position_m;
        const Vec2 velocity = all[b].velocity_mps - all[a].velocity_mps;
        for (double t = 0.0; t <= 0.6; t += 1e-3) {
          const bool approach = (apart + t * velocity).dot(velocity) < 0.0;
          if (approach && (apart + t * velocity).norm() < 0.18) first_s = std::min(first_s, t);
        }
        if (touches[a].at_s != touches[b].at_s || touches[a].at_s == kNever) continue;
        CHECK((touches[a].change_mps + touches[b].change_mps).norm() <= 1e-12);
        const Vec2 normal = (apart + touches[a].at_s * velocity).normalized();
        CHECK(std::abs((velocity + touches[b].change_mps - touches[a].change_mps).dot(normal)) <= 1e-9);
        ++touched;
      }
      if (first_s < 0.599) CHECK(std::abs(touches[a].at_s - first_s) <= 2e-3);
      if (touches[a].at_s == kNever) CHECK(first_s >= 0.599);
    }
  }
  CHECK(touched > 100);
}

}  // namespace
}  // namespace regista
