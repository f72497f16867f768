#include "logs/log_compare.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <regex>

#include "logs/message_numbers.h"
#include "modules/bus/channels.h"
#include "modules/convert/message.h"

namespace regista {
namespace {

using Bytes = std::vector<std::uint8_t>;
using ByStamp = std::map<Time, std::deque<Bytes>>;
using ByChannel = std::map<std::string, ByStamp>;
using Wanted = std::function<bool(const std::string&)>;

Wanted wanted_channels(const std::string& expression) {
  if (expression.empty()) return [](const std::string& channel) { return !channels::is_measured(channel); };
  try {
    const std::regex pattern(expression);
    return [pattern](const std::string& channel) { return std::regex_match(channel, pattern); };
  } catch (const std::regex_error& error) {
    throw LogError("'" + expression + "' is no regular expression: " + error.what());
  }
}

ByChannel read(const std::string& file, const Wanted& wanted) {
  LogReader reader(file);
  ByChannel messages;
  while (auto message = reader.next()) {
    if (!wanted(message->channel)) continue;
    const Time stamp = stamp_of(message->bytes).value_or(Time{});
    messages[message->channel][stamp].push_back(std::move(message->bytes));
  }
  return messages;
}

/// nullopt where the channel has no numbers or a message is malformed.
std::optional<double> numeric_difference(const std::string& channel, const Bytes& a, const Bytes& b) {
  try {
    const auto numbers_a = message_numbers(channel, a);
    const auto numbers_b = message_numbers(channel, b);
    if (!numbers_a || !numbers_b) return std::nullopt;
    return difference(*numbers_a, *numbers_b);
  } catch (const MessageError&) {
    return std::nullopt;
  }
}

void compare(const Bytes& a, const Bytes& b, Time stamp, std::optional<double> tolerance, ChannelComparison& out) {
  bool same = a == b;
  if (!same) {
    const auto apart = numeric_difference(out.channel, a, b);
    if (apart) out.largest_difference = std::max(out.largest_difference, *apart);
    same = tolerance && apart && *apart <= *tolerance;
  }
  ++(same ? out.matched : out.different);
  if (!same && !out.first_different) out.first_different = stamp;
}

std::int64_t count(const ByStamp& messages) {
  std::int64_t sum = 0;
  for (const auto& [stamp, list] : messages) sum += static_cast<std::int64_t>(list.size());
  return sum;
}

ChannelComparison compare_channel(const std::string& channel, const ByStamp& a, const ByStamp& b,
                                  std::optional<double> tolerance) {
  ChannelComparison out;
  out.channel = channel;
  for (const auto& [stamp, from_a] : a) {
    const auto from_b = b.find(stamp);
    if (from_b == b.end()) continue;
    const std::size_t pairs = std::min(from_a.size(), from_b->second.size());
    for (std::size_t i = 0; i < pairs; ++i) compare(from_a[i], from_b->second[i], stamp, tolerance, out);
  }
  out.only_in_a = count(a) - out.matched - out.different;
  out.only_in_b = count(b) - out.matched - out.different;
  return out;
}

}  // namespace

std::vector<ChannelComparison> compare_logs(const std::string& a, const std::string& b, const CompareOptions& options) {
  const Wanted wanted = wanted_channels(options.channels);
  ByChannel messages_a = read(a, wanted);
  ByChannel messages_b = read(b, wanted);
  for (const auto& [channel, messages] : messages_b) messages_a.try_emplace(channel);
  std::vector<ChannelComparison> comparison;
  for (const auto& [channel, messages] : messages_a) {
    comparison.push_back(compare_channel(channel, messages, messages_b[channel], options.tolerance));
  }
  return comparison;
}

bool all_match(const std::vector<ChannelComparison>& comparison) {
  std::int64_t matched = 0;
  for (const ChannelComparison& channel : comparison) {
    if (channel.different + channel.only_in_a + channel.only_in_b > 0) return false;
    matched += channel.matched;
  }
  return matched > 0;
}

}  // namespace regista
