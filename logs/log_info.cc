#include "logs/log_info.h"

#include <algorithm>
#include <map>

namespace regista {

LogInfo log_info(const std::string& file) {
  LogReader reader(file);
  LogInfo info;
  std::map<std::string, ChannelInfo> channels;
  while (const auto message = reader.next()) {
    const Time received = message->received;
    info.first = info.messages == 0 ? received : std::min(info.first, received);
    info.last = info.messages == 0 ? received : std::max(info.last, received);
    ++info.messages;
    ChannelInfo& channel = channels[message->channel];
    channel.first = channel.messages == 0 ? received : std::min(channel.first, received);
    channel.last = channel.messages == 0 ? received : std::max(channel.last, received);
    ++channel.messages;
    channel.bytes += static_cast<std::int64_t>(message->bytes.size());
  }
  for (auto& [name, channel] : channels) {
    channel.channel = name;
    info.channels.push_back(channel);
  }
  info.file_bytes = reader.file_bytes();
  info.damaged_bytes = reader.unread_bytes();
  return info;
}

double rate_hz(const ChannelInfo& channel) {
  const double seconds = to_seconds(channel.last - channel.first);
  return seconds > 0.0 ? static_cast<double>(channel.messages - 1) / seconds : 0.0;
}

}  // namespace regista
