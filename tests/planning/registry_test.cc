// The table of planners and how a wrong name is answered.
#include "planning/registry.h"

#include <catch2/catch.hpp>
#include <set>

#include "world_model/params.h"

namespace regista {

TEST_CASE("the registry's names are unique and its lines are filled") {
  std::set<std::string_view> names;
  for (const PlannerEntry& entry : planners()) {
    CHECK(names.insert(entry.name).second);
    CHECK_FALSE(entry.what.empty());
    CHECK_FALSE(entry.source.empty());
    CHECK(make_planner(entry.name) != nullptr);
    CHECK(planner_entry(entry.name).make == entry.make);
  }
  CHECK(names.count(kDefaultPlanner) == 1);
}

TEST_CASE("an unknown planner is answered in one line with the nearest name and the list") {
  try {
    make_planner("visibilty_sampling");
    FAIL("no throw");
  } catch (const UnknownPlanner& error) {
    const std::string what = error.what();
    CHECK_THAT(what, Catch::StartsWith("unknown planner 'visibilty_sampling', did you mean 'visibility_sampling'?"));
    for (const PlannerEntry& entry : planners()) CHECK_THAT(what, Catch::Contains(std::string(entry.name)));
    CHECK(what.find('\n') == std::string::npos);
  }
  CHECK_THROWS_AS(planner_entry(""), UnknownPlanner);
}

TEST_CASE("the nearest name needs the fewest letters changed, the first of equals is it") {
  CHECK(nearest_name("rtt", {"visibility_sampling", "rrt", "prm"}) == "rrt");
  CHECK(nearest_name("kitten", {"sitting", "bitten", "mitten"}) == "bitten");
  CHECK(nearest_name("", {"abc", "ab"}) == "ab");
  CHECK(nearest_name("rrt", {}).empty());
}

}  // namespace regista
