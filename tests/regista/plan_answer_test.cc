// `regista plan`'s answers: whole lines in, whole lines out, whatever the line.
#include "modules/regista/plan_answer.h"

#include <catch2/catch.hpp>
#include <memory>
#include <random>

#include "planning/registry.h"

namespace regista {
namespace {

using nlohmann::json;

/// Counts a nanosecond with every look.
std::function<std::int64_t()> ticking() {
  return [now = std::make_shared<std::int64_t>(0)] { return ++*now; };
}

json answer(const std::string& line, const std::string& planner = std::string(kDefaultPlanner), int repeat = 1) {
  return json::parse(answer_line(line, *make_planner(planner), planner, repeat, ticking()));
}

constexpr const char* kSingle =
    R"({"id":"a","field":{"length":12,"width":9},"start":[-1,0],"goal":[1,0],"radius":0.09,"obstacles":[{"disc":[0,0,0.2]}]})";
constexpr const char* kTeam =
    R"({"id":12,"field":{"length":12,"width":9},"radius":0.09,"obstacles":[{"disc":[0,0,0.2]}],
        "robots":[{"start":[-1,0],"goal":[1,0]},{"start":[-1,0],"goal":[1,0],"ignore":[0]}]})";

TEST_CASE("every planner answers a query with a path around the obstacle") {
  for (const PlannerEntry& entry : planners()) {
    INFO(entry.name);
    const json out = answer(kSingle, std::string(entry.name));
    CHECK(out["id"] == "a");
    CHECK(out["planner"] == entry.name);
    CHECK(out["status"] == "ok");
    CHECK(out["reason"] == "");
    CHECK(out["start_moved"] == false);
    CHECK(out["goal_moved"] == false);
    CHECK(out["path"].front() == json{-1.0, 0.0});
    CHECK(out["path"].back() == json{1.0, 0.0});
    CHECK(out["path"].size() >= 3);
    CHECK(out["length"] > 2.0);
    CHECK(out["time_us"] > 0.0);
  }
}

TEST_CASE("a team is answered robot by robot") {
  std::string line = kTeam;
  std::replace(line.begin(), line.end(), '\n', ' ');
  const json out = answer(line);
  CHECK(out["id"] == 12);
  CHECK(out["status"] == "ok");
  REQUIRE(out["plans"].size() == 2);
  CHECK(out["plans"][0]["length"] > 2.0);
  CHECK(out["plans"][1]["length"] == 2.0);
  CHECK(out["plans"][1]["path"].size() == 2);
  CHECK_FALSE(out.contains("path"));
}

TEST_CASE("covered starts and goals are told") {
  json query = json::parse(kSingle);
  query["start"] = {0.1, 0.0};
  CHECK(answer(query.dump())["start_moved"] == true);
  query["start"] = {-1, 0};
  query["goal"] = {0.1, 0.0};
  const json out = answer(query.dump());
  CHECK(out["goal_moved"] == true);
  CHECK(out["status"] == "ok");
}

TEST_CASE("start = goal is a path of one point") {
  json query = json::parse(kSingle);
  query["goal"] = query["start"];
  const json out = answer(query.dump());
  CHECK(out["status"] == "ok");
  CHECK(out["path"].size() == 1);
  CHECK(out["length"] == 0.0);
}

TEST_CASE("the same query has the same answer, whatever was asked before and however often it is repeated") {
  for (const PlannerEntry& entry : planners()) {
    const auto planner = make_planner(entry.name);
    const auto ask = [&, name = std::string(entry.name)](const std::string& line, int repeat) {
      json out = json::parse(answer_line(line, *planner, name, repeat, ticking()));
      out.erase("time_us");
      for (json& plan : out.value("plans", json::array())) plan.erase("time_us");
      if (out.contains("plans")) {
        for (json& plan : out["plans"]) plan.erase("time_us");
      }
      return out;
    };
    const json first = ask(kSingle, 1);
    ask(kTeam, 3);
    CHECK(ask(kSingle, 5) == first);
  }
}

TEST_CASE("the time is the least of the repeats") {
  // Every look at the clock takes longer than the one before, so the first repeat is the fastest.
  const auto slower = [now = std::make_shared<std::int64_t>(0), step = std::make_shared<std::int64_t>(0)] {
    return *now += ++*step;
  };
  const PlanQuery query = parse_query(json::parse(kTeam));
  const auto planner = make_planner(kDefaultPlanner);
  const QueryAnswer once = answer_query(*planner, query, 1, slower);
  const auto again = [now = std::make_shared<std::int64_t>(0), step = std::make_shared<std::int64_t>(0)] {
    return *now += ++*step;
  };
  const QueryAnswer often = answer_query(*planner, query, 4, again);
  CHECK(often.total_ns == once.total_ns);
  CHECK(often.plan_ns == once.plan_ns);
  CHECK(once.total_ns >= once.plan_ns[0] + once.plan_ns[1]);
}

TEST_CASE("a spent budget is not_found, and no budget is none") {
  json query = json::parse(kSingle);
  query["budget_us"] = 0;
  const json out = answer(query.dump(), "rrt");
  CHECK(out["status"] == "not_found");
  CHECK(out["reason"] != "");
  query["budget_us"] = 1e9;
  CHECK(answer(query.dump(), "rrt")["status"] == "ok");
}

TEST_CASE("what is wrong is answered with the id, status invalid and the reason") {
  json query = json::parse(kSingle);
  query.erase("goal");
  const json out = answer(query.dump());
  CHECK(out["id"] == "a");
  CHECK(out["status"] == "invalid");
  CHECK(out["reason"] == "goal: is missing");
  CHECK(out["path"].empty());
  CHECK(out["planner"] == kDefaultPlanner);
  CHECK(answer("nonsense")["id"].is_null());
  CHECK(answer("\xFF\xFE{")["status"] == "invalid");
}

TEST_CASE("no line, however mangled, does anything but be answered in one line") {
  std::mt19937_64 random(2025);
  const auto planner = make_planner(kDefaultPlanner);
  for (int round = 0; round < 3000; ++round) {
    std::string line = random() % 2 == 0 ? kSingle : kTeam;
    std::erase(line, '\n');
    for (std::uint64_t edits = 1 + random() % 3; edits > 0; --edits) {
      const std::size_t at = random() % line.size();
      switch (random() % 3) {
        case 0:
          line[at] = static_cast<char>(random() % 256);
          break;
        case 1:
          line.erase(at, 1 + random() % 8);
          break;
        default:
          line.insert(at, std::string(1 + random() % 3, "0123456789-e.,[]{}\""[random() % 19]));
          break;
      }
    }
    std::string out;
    REQUIRE_NOTHROW(out = answer_line(line, *planner, "p", 1, ticking()));
    INFO(line);
    REQUIRE(out.find('\n') == std::string::npos);
    REQUIRE(json::parse(out).contains("status"));
  }
}

}  // namespace
}  // namespace regista
