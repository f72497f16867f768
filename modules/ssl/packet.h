// Bytes from the network to a protobuf message: for everything that arrives by the league's protocols.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "modules/convert/message.h"

namespace regista {

/// A text of foreign origin as part of one line for people: control characters become blanks, the end is cut off.
inline std::string one_line(std::string text) {
  constexpr std::size_t kLongest = 200;  // fits a terminal's two lines
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "…";
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

/// Throws MessageError where the bytes are no such message or a required field is missing. The partial parse keeps
/// protobuf from writing its own complaints to stderr.
template <class Packet>
Packet parse_packet(std::span<const std::uint8_t> bytes) {
  Packet packet;
  if (!packet.ParsePartialFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    throw MessageError("not a well-formed " + packet.GetTypeName());
  }
  if (!packet.IsInitialized())
    throw MessageError("required fields missing: " + one_line(packet.InitializationErrorString()));
  return packet;
}

}  // namespace regista
