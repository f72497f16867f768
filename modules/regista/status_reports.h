// The STATUS reports of all modules on the bus, process by process: two that run under one name are told apart.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "modules/bus/service_values.h"

namespace regista {

struct StatusReport {
  ModuleStatus status;  ///< the newest
  Time first{};         ///< arrival of the first
  Time last{};          ///< arrival of the newest
};

class StatusReports {
 public:
  /// Reports older than this tell nothing: modules report once a second.
  static constexpr Duration kFresh = std::chrono::seconds(3);

  void take(ModuleStatus status, Time now);

  /// Drops what is no longer fresh.
  void forget_old(Time now);

  /// nullptr where that process has not reported lately.
  const StatusReport* of(const std::string& module, const std::string& host, int pid) const;

  /// Sorted by module, host and process.
  std::vector<StatusReport> all() const;

  /// Other processes that report under the name of this one while it does. Not its predecessor, whose last report came
  /// before its first.
  std::vector<ModuleStatus> twins_of(const StatusReport& report) const;

 private:
  using Key = std::tuple<std::string, std::string, int>;  ///< module, host, pid

  std::map<Key, StatusReport> reports_;
};

/// One line that says what to do; nothing where there are no twins.
std::string twins_text(const std::vector<ModuleStatus>& twins);

}  // namespace regista
