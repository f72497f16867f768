// Reads an LCM log message by message; a log cut off by a crash or a full disk gives all its whole messages.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logs/log_error.h"
#include "world_model/types/time.h"

namespace lcm {
class LogFile;
}

namespace regista {

struct LogMessage {
  Time received{};  ///< by the logger
  std::string channel;
  std::vector<std::uint8_t> bytes;
  bool operator==(const LogMessage&) const = default;
};

/// The stamp every message of ours carries after its fingerprint; nullopt where the bytes are too few for one.
std::optional<Time> stamp_of(const std::vector<std::uint8_t>& bytes);

class LogReader {
 public:
  /// Throws LogError when the file is missing, a folder or not readable.
  explicit LogReader(const std::string& file);
  ~LogReader();
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;

  /// The next whole message; nullopt at the end of the file. What is damaged is skipped.
  std::optional<LogMessage> next();

  std::int64_t file_bytes() const { return file_bytes_; }

  /// Bytes that belong to no message handed out so far; after the end: how much of the file is damaged.
  std::int64_t unread_bytes() const { return file_bytes_ - message_bytes_; }

 private:
  std::int64_t file_bytes_ = 0;
  std::int64_t message_bytes_ = 0;
  std::unique_ptr<lcm::LogFile> log_;
};

/// Throws LogError when the file cannot be read or holds no whole message: there is nothing to show or to play.
void require_message(const std::string& file);

}  // namespace regista
