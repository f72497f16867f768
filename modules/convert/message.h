// For the converters: how a value becomes an LCM message and back. Every type has one specialisation of MessageOf, and
// its .cc file instantiates encode and decode; nothing else knows the generated classes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "modules/convert/codec.h"

namespace regista {

/// Specialised per value type with
///   using Message = <generated class>;
///   static Message to_message(const Value&);
///   static Value from_message(const Message&);            // throws MessageError
///   static constexpr std::array<std::size_t, N> kElementBytes;  // least encoded size of one element of each list,
///                                                         // in the order of the counts, which follow stamp_us
template <class Value>
struct MessageOf;

/// Refuses list counts that the bytes cannot hold, before the generated decoder would allocate for them.
/// Layout: 8 bytes fingerprint, 8 bytes stamp_us, then one big-endian int32 per list.
void check_counts(std::span<const std::uint8_t> bytes, std::span<const std::size_t> element_bytes);

template <class Value>
std::vector<std::uint8_t> encode(const Value& value) {
  const auto message = MessageOf<Value>::to_message(value);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  if (message.encode(bytes.data(), 0, static_cast<int>(bytes.size())) != static_cast<int>(bytes.size())) {
    throw MessageError("a value of " + std::to_string(bytes.size()) + " bytes could not be encoded");
  }
  return bytes;
}

template <class Value>
Value decode(std::span<const std::uint8_t> bytes) {
  check_counts(bytes, MessageOf<Value>::kElementBytes);
  typename MessageOf<Value>::Message message{};
  int used = -1;
  try {
    used = message.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
  } catch (const std::exception& error) {
    throw MessageError(std::string("decoding failed: ") + error.what());
  }
  if (used < 0) throw MessageError("truncated or of another type");
  if (used != static_cast<int>(bytes.size())) {
    throw MessageError(std::to_string(static_cast<int>(bytes.size()) - used) + " bytes too many");
  }
  return MessageOf<Value>::from_message(message);
}

// What the converters share. All throw MessageError with the field's name and value.

double finite(double value, const char* field);
double at_least(double value, double low, const char* field);

[[noreturn]] void refuse(const std::string& why);

/// The parts, texts and numbers, make up the message; they are put together only where it is needed, for this stands in
/// the way of every number of every message.
template <class... Parts>
void require(bool holds, const Parts&... parts) {
  if (holds) return;
  std::string why;
  const auto add = [&](const auto& part) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>) {
      why += std::to_string(part);
    } else {
      why += part;
    }
  };
  (add(parts), ...);
  refuse(why);
}

/// A list's length as LCM counts it.
template <class List>
std::int32_t count_of(const List& list) {
  if (list.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw MessageError("a list of " + std::to_string(list.size()) + " elements is too long");
  }
  return static_cast<std::int32_t>(list.size());
}

/// True when the key strictly grows along the list.
template <class List, class Key>
bool strictly_sorted(const List& list, Key key) {
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (!(key(list[i - 1]) < key(list[i]))) return false;
  }
  return true;
}

}  // namespace regista
