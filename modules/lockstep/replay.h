// Plays a recorded log into fresh modules, with their own recorded outputs left out, and collects what they say
// instead. Over a lock-step log the answers are the recorded ones, byte for byte.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "logs/log_reader.h"
#include "modules/lockstep/lock_step.h"

namespace regista {

struct Replay {
  std::vector<LogMessage> recorded;  ///< the log's messages on the output channels, but for measured ones
  std::vector<LogMessage> replayed;  ///< what the fresh modules published on them, at the log's times
};

/// `outputs` is a regular expression over the channels the modules publish; `add_modules` puts the modules into the
/// loop. Throws LogError when the log cannot be read, BusError when LCM cannot, std::regex_error on a bad expression.
Replay replay_log(const std::string& log_file, const std::string& outputs,
                  const std::function<void(LockStep&)>& add_modules);

}  // namespace regista
