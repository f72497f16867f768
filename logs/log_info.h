// What is in a log: channels, counts, rates, duration, size.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "logs/log_reader.h"

namespace regista {

struct ChannelInfo {
  std::string channel;
  std::int64_t messages = 0;
  std::int64_t bytes = 0;  ///< of the messages alone
  Time first{};            ///< received
  Time last{};             ///< received
  bool operator==(const ChannelInfo&) const = default;
};

struct LogInfo {
  std::int64_t file_bytes = 0;
  std::int64_t damaged_bytes = 0;  ///< that belong to no whole message
  std::int64_t messages = 0;
  Time first{};                       ///< received
  Time last{};                        ///< received
  std::vector<ChannelInfo> channels;  ///< sorted by name
};

/// Throws LogError when the file cannot be read; damage is told in the result.
LogInfo log_info(const std::string& file);

/// Messages per second between the first and the last; 0 where that is no time.
double rate_hz(const ChannelInfo& channel);

}  // namespace regista
