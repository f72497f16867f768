// What `regista up` writes: on a terminal one table, redrawn in place, with the last events below it; elsewhere a line
// per event and the table now and then.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "modules/regista/status_table.h"

namespace regista {

class Display {
 public:
  /// To stdout; finds out by itself whether that is a terminal.
  Display();

  /// Something happened.
  void event(const std::string& line);

  /// Shows the table when it is time to.
  void update(Time now, const std::vector<ModuleRow>& rows);

 private:
  void redraw(const std::vector<ModuleRow>& rows);

  bool is_terminal_;
  std::deque<std::string> events_;  ///< the last few
  std::size_t drawn_lines_ = 0;
  Time next_{};
};

}  // namespace regista
