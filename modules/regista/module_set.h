// Which modules `regista up` starts, with which flags.
#pragma once

#include <string>
#include <vector>

namespace regista {

struct ChildSpec {
  std::string name;     ///< as in STATUS: "planner.Y"
  std::string program;  ///< "regista-planner", in the folder of the running executable
  std::vector<std::string> arguments;
  bool may_end = false;  ///< when it ends in order by itself, somebody wanted that: a window was closed
  bool operator==(const ChildSpec&) const = default;
};

struct LaunchOptions {
  std::string scenario;  ///< as typed: a file, a shipped name, or empty for the modules' defaults
  std::string lcm_url;
  std::vector<std::string> settings;  ///< section.key=value
  bool real_field = false;            ///< ssl-vision, ssl-referee and ssl-radio in place of sim
  bool stated_referee = false;        ///< the task says what the referee says, so ssl-referee stays away
  bool viewer = false;
  std::vector<std::string> left_out;  ///< names without team: "planner" leaves out both
};

/// Names that may be left out, in the order in which modules start.
const std::vector<std::string>& module_names();

/// In the order in which they start: the field first, then as the data flow.
std::vector<ChildSpec> modules_for(const LaunchOptions& options);

}  // namespace regista
