// What the subcommands of `regista` share: how one is chosen and how it fails.
#pragma once

#include <functional>
#include <stdexcept>

namespace CLI {
class App;
}

namespace regista {

/// What the command line asks for: set while it is parsed, run afterwards. Returns the exit status.
using Action = std::function<int()>;

/// Exit status 1; what() is one line that says what to do.
struct CommandError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Exit status 2: the command line makes no sense.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace regista
