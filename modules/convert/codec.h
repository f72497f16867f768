// Values as bytes and back, for whoever sends or receives: the LCM encoding of the value's message type. The generated
// classes stay behind this header; each value type is instantiated in its converter's file.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace regista {

/// A message that makes no sense; what() names the field and the value.
struct MessageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws MessageError where the value cannot be encoded (a text with a zero byte in it).
template <class Value>
std::vector<std::uint8_t> encode(const Value& value);

/// Throws MessageError, and nothing else, on truncated, foreign or hostile bytes.
template <class Value>
Value decode(std::span<const std::uint8_t> bytes);

}  // namespace regista
