#include "modules/regista/module_set.h"

#include <algorithm>

namespace regista {
namespace {

bool is_wanted(const std::string& module, const LaunchOptions& options) {
  if (std::count(options.left_out.begin(), options.left_out.end(), module) > 0) return false;
  if (module == "sim") return !options.real_field;
  if (module == "ssl-referee" && options.stated_referee) return false;
  if (module.starts_with("ssl-")) return options.real_field;
  if (module == "viewer") return options.viewer;
  return true;
}

ChildSpec spec_of(const std::string& module, const std::string& team, const LaunchOptions& options) {
  ChildSpec spec{module + (team.empty() ? "" : "." + team),
                 "regista-" + module,
                 {"--lcm-url", options.lcm_url},
                 module == "viewer"};
  const auto add = [&spec](const std::string& flag, const std::string& value) {
    spec.arguments.push_back(flag);
    spec.arguments.push_back(value);
  };
  if (!options.scenario.empty()) add("--config", options.scenario);
  for (const std::string& setting : options.settings) add("--set", setting);
  if (!team.empty()) add("--team", team);
  return spec;
}

}  // namespace

const std::vector<std::string>& module_names() {
  static const std::vector<std::string> names{"sim",  "ssl-vision", "ssl-referee", "ssl-radio", "world-model",
                                              "task", "planner",    "controller",  "viewer"};
  return names;
}

std::vector<ChildSpec> modules_for(const LaunchOptions& options) {
  std::vector<ChildSpec> specs;
  for (const std::string& module : module_names()) {
    if (!is_wanted(module, options)) continue;
    const bool per_team = module == "planner" || module == "controller";
    for (const char* team : {"Y", "B"}) {
      if (per_team) specs.push_back(spec_of(module, team, options));
    }
    if (!per_team) specs.push_back(spec_of(module, "", options));
  }
  return specs;
}

}  // namespace regista
