// Writes an LCM log, in lcm-logger's format, with the times it is told: the lock-step runner's recorder. Same messages
// and times, same bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "logs/log_error.h"
#include "world_model/types/time.h"

namespace lcm {
class LogFile;
}

namespace regista {

class LogWriter {
 public:
  /// Replaces the file. Throws LogError when it cannot be written.
  explicit LogWriter(const std::string& file);

  /// Closes; an error that comes to light only now is lost, so call close() where that matters.
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /// Appends one message as received at that time. The channel is 1 to 999 bytes long. Throws LogError when the disk
  /// refuses, which may come to light some messages later.
  void write(Time received, const std::string& channel, std::span<const std::uint8_t> bytes);

  /// Brings everything to the file. Throws LogError when that fails. Nothing may be written afterwards.
  void close();

 private:
  [[noreturn]] void fail() const;

  std::string file_;
  std::unique_ptr<lcm::LogFile> log_;
};

}  // namespace regista
