#include "planning/z_order.h"

#include <catch2/catch.hpp>
#include <random>

#include "planning/uniform.h"

namespace regista {
namespace {

TEST_CASE("Z-order: all places once, along the curve, equal ones in their order, whatever was sorted before") {
  std::mt19937_64 random(1);
  ZOrder order;
  for (const std::size_t count : {0U, 1U, 2U, 100U, 1000U}) {
    order.clear(3.0);
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = uniform(random, -3.0, 3.0);
      places.push_back(i % 5 == 4 ? places.back() : Vec2(x, uniform(random, -3.0, 3.0)));
      order.add(places.back());
    }
    const std::span<const ZOrder::Entry> sorted = order.sort();
    REQUIRE(sorted.size() == count);
    std::vector<int> seen(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      ++seen[sorted[i].index];
      if (i == 0) continue;
      REQUIRE(sorted[i - 1].key <= sorted[i].key);
      if (sorted[i - 1].key == sorted[i].key) REQUIRE(sorted[i - 1].index < sorted[i].index);
    }
    REQUIRE(seen == std::vector<int>(count, 1));
  }
}

TEST_CASE("Z-order: quarter after quarter of the field, down to the outermost places") {
  ZOrder order;
  order.clear(1.0);
  for (const Vec2& place : {Vec2(1, 1), Vec2(-1, 1), Vec2(1, -1), Vec2(-1, -1), Vec2(-0.9, -0.9)}) order.add(place);
  std::vector<std::uint32_t> indices;
  for (const ZOrder::Entry& entry : order.sort()) indices.push_back(entry.index);
  CHECK(indices == std::vector<std::uint32_t>{3, 4, 2, 1, 0});
}

TEST_CASE("Z-order: a field of one point") {
  ZOrder order;
  order.clear(0.0);
  order.add(Vec2::Zero());
  order.add(Vec2::Zero());
  CHECK(order.sort()[1].index == 1);
}

}  // namespace
}  // namespace regista
