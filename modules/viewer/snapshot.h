// When a picture is taken, of a live bus or of a log, and how a log is played.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "modules/process/process_loop.h"
#include "modules/viewer/viewer_module.h"

namespace regista {

struct SnapshotError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Seconds after the first message (of a log: after the first world state); nullopt: as soon as there is enough to see.
using SnapshotAt = std::optional<double>;

/// Decides from what has come in and from a clock, the bus's or a log's.
class SnapshotTrigger {
 public:
  explicit SnapshotTrigger(SnapshotAt at) : at_(at) {}

  /// True from the moment the picture is to be taken. now must not go back.
  bool due(bool heard, bool complete, Time now);
  /// Another picture: seconds after the same first message.
  void set(SnapshotAt at) { at_ = at; }

 private:
  SnapshotAt at_;
  Time heard_at_ = Time::max();     ///< max: not yet
  Time complete_at_ = Time::max();  ///< max: not yet
};

/// Lets a live bus fill the module until the picture is due. Throws SnapshotError when nothing comes, or when stopped.
void await_picture(ViewerModule& module, ProcessLoop& loop, const Bus& bus, SnapshotTrigger& trigger,
                   const std::string& url, const std::function<bool()>& stopped);

/// Hands the module one message of a log that is read at full speed; false at the log's end.
bool play_next(ViewerModule& module, Bus& bus);

/// Plays a log into the module, as fast as it reads, until the picture is due or the log ends. Throws SnapshotError
/// when the log holds nothing that can be seen, or when stopped.
void play_until_picture(ViewerModule& module, Bus& bus, SnapshotTrigger& trigger, const std::string& url,
                        const std::function<bool()>& stopped);

bool is_log(const std::string& url);

/// A log's URL with speed=0, as fast as it reads, where it names no speed; any other URL as it is.
std::string at_full_speed(const std::string& url);

}  // namespace regista
