// Which channels each module publishes: what a replay leaves out when a module is to be run afresh. The table is the
// README's, as patterns.
#pragma once

#include <string>
#include <vector>

namespace regista {

/// Patterns (regular expressions over whole channel names) of everything a module publishes, its TIMING and STATUS
/// included; REPLY is nobody's own. The name is as in STATUS ("sim", "world-model", "planner.Y"); without a team it
/// means both. Throws std::invalid_argument, listing the known names, for an unknown module.
std::vector<std::string> outputs_of(const std::string& module);

/// A pattern that matches every channel that none of the patterns matches; ".*" when there are none.
std::string all_but(const std::vector<std::string>& patterns);

}  // namespace regista
