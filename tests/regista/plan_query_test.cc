// `regista plan`'s queries: what is understood, what is refused and with which words.
#include "modules/regista/plan_query.h"

#include <catch2/catch.hpp>

namespace regista {
namespace {

using nlohmann::json;

json good() {
  return json::parse(
      R"({"id": 1, "field": {"length": 12, "width": 9, "margin": 0.3}, "start": [-1, 0], "goal": [1, 0.5],
                         "radius": 0.09, "obstacles": [{"disc": [0, 0, 0.1]}, {"capsule": [1, 1, 2, 2, 0]},
                         {"rectangle": [-3, -2, -2, -1, 0.2]}], "seed": 7, "budget_us": 1000})");
}

json team() {
  json query = good();
  query.erase("start");
  query.erase("goal");
  query["robots"] =
      json::parse(R"([{"start": [0, 1], "goal": [0, 2], "ignore": [2, 0, 2]}, {"start": [0, 3], "goal": [0, 4]}])");
  return query;
}

/// The query with the value at the pointer replaced.
json with(json query, const std::string& pointer, const json& value) {
  query[json::json_pointer(pointer)] = value;
  return query;
}

std::string refusal(const json& query) {
  try {
    parse_query(query);
  } catch (const QueryError& error) {
    return error.what();
  }
  return "none";
}

TEST_CASE("a query becomes bounds, grown obstacles and a request") {
  const PlanQuery query = parse_query(good());
  CHECK(query.bounds.half_extent_m.isApprox(Vec2(6.0 + 0.3 - 0.09, 4.5 + 0.3 - 0.09)));
  REQUIRE(query.obstacles.size() == 3);
  CHECK(query.obstacles[0] == disc({0, 0}, 0.1 + 0.09));
  CHECK(query.obstacles[1] == capsule({1, 1}, {2, 2}, 0.0 + 0.09));
  CHECK(query.obstacles[2] == rounded_rectangle({-3, -2}, {-2, -1}, 0.2 + 0.09));
  REQUIRE(query.requests.size() == 1);
  CHECK(query.requests[0].start == Vec2(-1, 0));
  CHECK(query.requests[0].goal == Vec2(1, 0.5));
  CHECK(query.requests[0].seed == 7);
  CHECK(query.budget_us == 1000.0);
  CHECK_FALSE(query.is_team);
}

TEST_CASE("margin is one number or two, and may be missing") {
  const Vec2 inner(6.0 - 0.09, 4.5 - 0.09);
  CHECK(parse_query(with(good(), "/field/margin", {0.6, 0.3})).bounds.half_extent_m.isApprox(inner + Vec2(0.6, 0.3)));
  json query = good();
  query["field"].erase("margin");
  CHECK(parse_query(query).bounds.half_extent_m.isApprox(inner));
}

TEST_CASE("what may be missing has its default") {
  json query = good();
  query.erase("id");
  query.erase("seed");
  query.erase("budget_us");
  const PlanQuery parsed = parse_query(query);
  CHECK(parsed.requests[0].seed == 1);
  CHECK_FALSE(parsed.budget_us.has_value());
}

TEST_CASE("a team's robots ignore obstacles by index, sorted and once") {
  const PlanQuery query = parse_query(team());
  CHECK(query.is_team);
  REQUIRE(query.requests.size() == 2);
  CHECK(query.requests[0].ignored == std::vector<std::size_t>{0, 2});
  CHECK(query.requests[1].ignored.empty());
  CHECK(query.requests[1].goal == Vec2(0, 4));
  CHECK(parse_query(with(team(), "/robots", json::array())).requests.empty());
}

TEST_CASE("what is required is missed by its name") {
  for (const char* key : {"field", "start", "goal", "radius", "obstacles"}) {
    json query = good();
    query.erase(key);
    CHECK_THAT(refusal(query), Catch::Contains(key) && Catch::Contains("is missing"));
  }
  json query = good();
  query["field"].erase("width");
  CHECK(refusal(query) == "field.width: is missing");
  query = team();
  query["robots"][1].erase("goal");
  CHECK(refusal(query) == "robots[1].goal: is missing");
}

TEST_CASE("numbers that are none, or are no place on a field, are refused") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const char* pointer : {"/start/0", "/goal/1", "/radius", "/field/length", "/field/margin", "/obstacles/0/disc/2",
                              "/obstacles/1/capsule/3", "/obstacles/2/rectangle/4", "/budget_us"}) {
    for (const json& value : {json("1"), json(nullptr), json(true), json(std::nan("")), json(infinity), json(-infinity),
                              json(1e300), json(-1e300), json::object()}) {
      INFO(pointer << " = " << value.dump());
      CHECK(refusal(with(good(), pointer, value)) != "none");
    }
  }
  CHECK(refusal(with(good(), "/start/0", 1e300)) == "start[0]: 1e+300 is outside [-10000.0, 10000.0]");
}

TEST_CASE("lists of the wrong length are refused") {
  CHECK(refusal(with(good(), "/start", {1})) == "start: must be a list of 2 numbers");
  CHECK(refusal(with(good(), "/goal", {1, 2, 3})) == "goal: must be a list of 2 numbers");
  CHECK(refusal(with(good(), "/obstacles/0/disc", {1, 2})) == "obstacles[0].disc: must be a list of 3 numbers");
  CHECK(refusal(with(good(), "/obstacles/1/capsule", {1, 2, 3, 4})) ==
        "obstacles[1].capsule: must be a list of 5 numbers");
  CHECK(refusal(with(good(), "/obstacles/2/rectangle", {1, 2, 3, 4})) ==
        "obstacles[2].rectangle: must be a list of 5 numbers");
  CHECK(refusal(with(good(), "/obstacles", 3)) == "obstacles: must be a list");
  CHECK(refusal(with(good(), "/field/margin", {1, 2, 3})) == "field.margin: must be a list of 2 numbers");
}

TEST_CASE("obstacles that are none are refused") {
  CHECK(refusal(with(good(), "/obstacles/0/disc/2", -0.1)) ==
        "obstacles[0].disc: the radius is -0.1, must be at least 0");
  CHECK_THAT(refusal(with(good(), "/obstacles/0", {{"disk", {0, 0, 1}}})),
             Catch::Contains("unknown shape 'disk', known: disc, capsule, rectangle"));
  CHECK(refusal(with(good(), "/obstacles/0", json::object())) != "none");
  CHECK(refusal(with(good(), "/obstacles/0", {{"disc", {0, 0, 1}}, {"capsule", {0, 0, 1, 1, 1}}})) != "none");
  CHECK_THAT(refusal(with(good(), "/obstacles/2/rectangle", {1, 0, 0, 1, 0})), Catch::Contains("min at most max"));
}

TEST_CASE("a negative radius, and a field without room, are refused") {
  CHECK(refusal(with(good(), "/radius", -0.09)) != "none");
  CHECK_THAT(refusal(with(good(), "/radius", 20.0)), Catch::Contains("no room"));
  CHECK_THAT(refusal(with(good(), "/field/margin", -10)), Catch::Contains("no room"));
}

TEST_CASE("an index that no obstacle has is refused") {
  for (const json& index :
       {json(3U), json(-1), json(18446744073709551615ULL), json(0.5), json("0"), json(nullptr), json(1e300)}) {
    CHECK_THAT(refusal(with(team(), "/robots/0/ignore/0", index)), Catch::Contains("robots[0].ignore"));
  }
  CHECK(refusal(with(team(), "/robots/0/ignore/0", 3U)) ==
        "robots[0].ignore: 3 is no index of an obstacle, there are 3");
  CHECK(refusal(with(team(), "/robots/0/ignore", 3)) != "none");
}

TEST_CASE("a seed is a whole number that is not negative") {
  CHECK(parse_query(with(good(), "/seed", 18446744073709551615ULL)).requests[0].seed == 18446744073709551615ULL);
  for (const json& seed : {json(-1), json(0.5), json("1"), json(nullptr)}) {
    CHECK(refusal(with(good(), "/seed", seed)) != "none");
  }
}

TEST_CASE("robots stand in place of start and goal") {
  json query = team();
  query["start"] = {0, 0};
  CHECK(refusal(query) != "none");
  CHECK(refusal(with(team(), "/robots", 1)) != "none");
  CHECK(refusal(with(team(), "/robots/0", 1)) != "none");
}

TEST_CASE("lines that are no JSON object are refused") {
  for (const char* line :
       {"{", "[]", "1", "null", "\"text\"", "{\"a\":NaN}", "{\"a\":1e999}", "{} {}", "\xFF", "{\"a\":\"\xFF\"}"}) {
    CHECK_THROWS_AS(parse_line(line), QueryError);
  }
  CHECK(parse_line("{\"id\":1}\r") == json{{"id", 1}});
}

}  // namespace
}  // namespace regista
