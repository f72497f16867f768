// Plays a recorded log into fresh modules, with their own recorded outputs left out, and collects what they say instead.
// Over a lock-step log the answers are the recorded ones, byte for byte.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "modules/lockstep/lock_step.h"

namespace regista {

struct LoggedMessage {
  Time at{};  ///< when it was published
  std::string channel;
  std::vector<std::uint8_t> bytes;
  bool operator==(const LoggedMessage&) const = default;
};

struct Replay {
  std::vector<LoggedMessage> recorded;  ///< the log's messages on the output channels, but for measured ones
  std::vector<LoggedMessage> replayed;  ///< what the fresh modules published on them
};

/// `outputs` is a regular expression over the channels the modules publish; `add_modules` puts the modules into the loop.
/// Throws BusError when the log cannot be read, std::regex_error on a bad expression.
Replay replay_log(const std::string& log_file, const std::string& outputs,
                  const std::function<void(LockStep&)>& add_modules);

}  // namespace regista
