// What people chose at run time with `planner use` and `param set`, read off REQUEST and REPLY: a module that is
// started again gets it as settings, for it has forgotten.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "modules/bus/service_values.h"

namespace regista {

class RuntimeChoices {
 public:
  /// Only choices for these modules, named as in STATUS, are kept.
  explicit RuntimeChoices(const std::vector<std::string>& modules);

  void take(const Request& request);

  /// A choice counts once its module has accepted it.
  void take(const Reply& reply);

  /// As --set takes them, "planner.yellow.use=rrt", in the order in which they were made; one per key, the last.
  std::vector<std::string> settings_of(const std::string& module) const;

 private:
  struct Choice {
    std::string key;
    std::string value;
  };
  std::deque<Request> asked_;                           ///< the last ones that no reply has come to yet
  std::map<std::string, std::vector<Choice>> choices_;  ///< by module, the newest last
};

}  // namespace regista
