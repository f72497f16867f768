// Packets made and read by the protobuf compiler, so that our own code stays out of it.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace regista {

/// The bytes of a message given in protobuf's text format. A missing required field only makes protoc warn.
/// Throws std::runtime_error where protoc fails.
std::string protoc_encode(const std::string& proto_file, const std::string& type, const std::string& text);

/// The text format of the bytes. Throws std::runtime_error where protoc fails.
std::string protoc_decode(const std::string& proto_file, const std::string& type, const std::string& bytes);

/// The field numbers and raw values of the bytes, whatever type they are of.
std::string protoc_decode_raw(const std::string& bytes);

inline std::string encode_vision(const std::string& text) {
  return protoc_encode("ssl_vision_wrapper.proto", "SSL_WrapperPacket", text);
}

inline std::string encode_referee(const std::string& text) {
  return protoc_encode("ssl_referee.proto", "Referee", text);
}

inline std::span<const std::uint8_t> as_bytes(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

}  // namespace regista
