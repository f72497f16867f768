// Protobuf's wire format written by hand, so that tests do not depend on our .proto files being right.
// Source: protobuf's "Encoding" guide.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace regista::wire {

inline std::string varint(std::uint64_t value) {
  std::string out;
  while (value >= 0x80) {
    out += static_cast<char>((value & 0x7f) | 0x80);
    value >>= 7;
  }
  return out + static_cast<char>(value);
}

inline std::string tag(int field, int wire_type) { return varint(static_cast<std::uint64_t>(field << 3 | wire_type)); }

template <class Bits>
std::string little_endian(Bits bits) {
  std::string out;
  for (std::size_t i = 0; i < sizeof bits; ++i) out += static_cast<char>(bits >> (8 * i) & 0xff);
  return out;
}

inline std::string of_int(int field, std::uint64_t value) { return tag(field, 0) + varint(value); }
inline std::string of_double(int field, double value) {
  return tag(field, 1) + little_endian(std::bit_cast<std::uint64_t>(value));
}
inline std::string of_bytes(int field, const std::string& bytes) {
  return tag(field, 2) + varint(bytes.size()) + bytes;
}
inline std::string of_float(int field, float value) {
  return tag(field, 5) + little_endian(std::bit_cast<std::uint32_t>(value));
}

}  // namespace regista::wire
