#include "modules/regista/status_reports.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace regista {
namespace {

// Far more than run on a bus; one that invents process ids must not fill the memory.
constexpr std::size_t kMostReports = 1000;

bool at_the_same_time(const StatusReport& a, const StatusReport& b) {
  return std::max(a.first, b.first) < std::min(a.last, b.last);
}

}  // namespace

void StatusReports::take(ModuleStatus status, Time now) {
  const Key key{status.module, status.host, status.pid};
  const auto known = reports_.find(key);
  if (known == reports_.end()) {
    if (reports_.size() < kMostReports) reports_.emplace(key, StatusReport{std::move(status), now, now});
    return;
  }
  known->second.status = std::move(status);
  known->second.last = now;
}

void StatusReports::forget_old(Time now) {
  std::erase_if(reports_, [now](const auto& entry) { return now - entry.second.last > kFresh; });
}

const StatusReport* StatusReports::of(const std::string& module, const std::string& host, int pid) const {
  const auto found = reports_.find({module, host, pid});
  return found == reports_.end() ? nullptr : &found->second;
}

std::vector<StatusReport> StatusReports::all() const {
  std::vector<StatusReport> all;
  for (const auto& [key, report] : reports_) all.push_back(report);
  return all;
}

std::vector<ModuleStatus> StatusReports::twins_of(const StatusReport& report) const {
  std::vector<ModuleStatus> twins;
  for (const auto& [key, other] : reports_) {
    if (other.status.module != report.status.module) continue;
    if (other.status.pid == report.status.pid && other.status.host == report.status.host) continue;
    if (at_the_same_time(other, report)) twins.push_back(other.status);
  }
  return twins;
}

std::string twins_text(const std::vector<ModuleStatus>& twins) {
  if (twins.empty()) return {};
  std::string who;
  for (const ModuleStatus& twin : twins) {
    who += fmt::format("{}pid {} on {}", who.empty() ? "" : " and ", twin.pid, twin.host);
  }
  return fmt::format("runs {} on this bus: also as {}, stop one", twins.size() == 1 ? "twice" : "more than once", who);
}

}  // namespace regista
