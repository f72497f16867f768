// A message as a flat list of numbers, so that two outputs of the same module can be compared within a tolerance.
// Counters (sequence, generation) are left out: a freshly started module counts from the beginning.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace regista {

struct MessageNumbers {
  struct Number {
    double value = 0.0;
    bool is_angle = false;  ///< radians, compared on the circle
  };
  std::vector<Number> numbers;
  std::string rest;  ///< what must be the same exactly: who, how many, which status
};

/// Of VISION, GEOMETRY, WORLD_STATE, TRUTH, TARGETS.*, PLAN.*, GRAPH.* and COMMANDS.*; nullopt for any other channel.
/// Throws MessageError on malformed bytes.
std::optional<MessageNumbers> message_numbers(const std::string& channel, std::span<const std::uint8_t> bytes);

/// The largest difference between numbers at the same place; infinite when lists or the rest differ.
double difference(const MessageNumbers& a, const MessageNumbers& b);

}  // namespace regista
