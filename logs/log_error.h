// What goes wrong with log files; what() is one line that names the file and says what to do.
#pragma once

#include <stdexcept>

namespace regista {

struct LogError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace regista
