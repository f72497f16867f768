// Compares what two logs say on the same channels, message by message, matched by stamp: a replay with its recording.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "logs/log_reader.h"

namespace regista {

struct CompareOptions {
  /// Regular expression over whole channel names; empty: all but those that carry measured durations.
  std::string channels;
  /// Largest allowed difference of any number, in its own unit; nullopt: the bytes must be the same. Channels without
  /// numbers to compare are compared by their bytes in both cases.
  std::optional<double> tolerance;
};

struct ChannelComparison {
  std::string channel;
  std::int64_t matched = 0;    ///< the same, or within the tolerance
  std::int64_t different = 0;  ///< same stamp, but not the same
  std::int64_t only_in_a = 0;
  std::int64_t only_in_b = 0;
  double largest_difference = 0.0;      ///< of messages compared by numbers; infinite: their lists or names differ
  std::optional<Time> first_different;  ///< stamp of the first that is different
  bool operator==(const ChannelComparison&) const = default;
};

/// One entry per channel found in either log, sorted by name. The n-th message of a stamp in a is matched with the n-th
/// of that stamp in b. Throws LogError when a file cannot be read or the expression is none; what follows damage in a
/// log counts as missing.
std::vector<ChannelComparison> compare_logs(const std::string& a, const std::string& b, const CompareOptions& options);

/// Every message of one log has its like in the other, and there is at least one.
bool all_match(const std::vector<ChannelComparison>& comparison);

}  // namespace regista
