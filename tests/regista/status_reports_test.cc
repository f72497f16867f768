// STATUS by process: two under one name are noticed, a predecessor is no twin.
#include "modules/regista/status_reports.h"

#include <catch2/catch.hpp>

namespace regista {
namespace {

constexpr Duration kSecond = std::chrono::seconds(1);

ModuleStatus status(const std::string& host, int pid) {
  ModuleStatus status;
  status.module = "planner.Y";
  status.host = host;
  status.pid = pid;
  return status;
}

TEST_CASE("two processes of one name are both told, whoever reports last") {
  StatusReports reports;
  for (int i = 0; i < 3; ++i) {
    reports.take(status("here", 1), Time{} + i * kSecond);
    reports.take(status("there", 1), Time{} + i * kSecond + kSecond / 2);
  }
  for (const auto& [host, other] : {std::pair{"here", "there"}, {"there", "here"}}) {
    const StatusReport* report = reports.of("planner.Y", host, 1);
    REQUIRE(report != nullptr);
    const auto twins = reports.twins_of(*report);
    REQUIRE(twins.size() == 1);
    CHECK(twins[0].host == other);
    CHECK_THAT(twins_text(twins), Catch::Contains("runs twice on this bus") && Catch::Contains(other));
  }
}

TEST_CASE("a predecessor is no twin, and is forgotten") {
  StatusReports reports;
  for (int i = 0; i < 3; ++i) reports.take(status("here", 1), Time{} + i * kSecond);
  for (int i = 3; i < 8; ++i) {
    reports.take(status("here", 2), Time{} + i * kSecond);
    reports.forget_old(Time{} + i * kSecond);
    CHECK(reports.twins_of(*reports.of("planner.Y", "here", 2)).empty());
  }
  CHECK(reports.of("planner.Y", "here", 1) == nullptr);
  CHECK(reports.all().size() == 1);
  CHECK(twins_text({}).empty());
}

}  // namespace
}  // namespace regista
