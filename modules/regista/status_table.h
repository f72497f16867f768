// The table of modules that `regista up` shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modules/bus/service_values.h"

namespace regista {

struct ModuleRow {
  std::string name;
  std::optional<int> pid;  ///< of the process, where there is one
  std::string state;       ///< "running", "starting", "silent", "restarting", "given up", "elsewhere"
  Duration uptime{};
  std::optional<ModuleStatus> status;  ///< the newest, where it is not too old to tell anything
  std::string note;
};

/// One line per module below a line of headings, each cut to `width` characters and without its end.
std::vector<std::string> table_lines(const std::vector<ModuleRow>& rows, std::size_t width);

/// The first `width` characters (UTF-8) of one line; control characters become blanks, for modules' words go to a
/// terminal.
std::string fit(const std::string& text, std::size_t width);

}  // namespace regista
