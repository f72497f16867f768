#include "modules/convert/message.h"

namespace regista {
namespace {

constexpr std::size_t kCountsBegin = 16;  // fingerprint and stamp_us

std::int64_t big_endian_int32(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | bytes[at + i];
  return static_cast<std::int32_t>(value);
}

}  // namespace

void check_counts(std::span<const std::uint8_t> bytes, std::span<const std::size_t> element_bytes) {
  if (bytes.size() < kCountsBegin + 4 * element_bytes.size()) {
    throw MessageError("truncated: " + std::to_string(bytes.size()) + " bytes");
  }
  std::size_t left = bytes.size() - kCountsBegin - 4 * element_bytes.size();
  for (std::size_t i = 0; i < element_bytes.size(); ++i) {
    const std::int64_t count = big_endian_int32(bytes, kCountsBegin + 4 * i);
    if (count < 0 || static_cast<std::size_t>(count) > left / element_bytes[i]) {
      throw MessageError("list " + std::to_string(i) + " claims " + std::to_string(count) + " elements in " +
                         std::to_string(left) + " bytes");
    }
    left -= static_cast<std::size_t>(count) * element_bytes[i];
  }
}

double finite(double value, const char* field) {
  if (!std::isfinite(value)) throw MessageError(std::string(field) + " is " + std::to_string(value));
  return value;
}

double at_least(double value, double low, const char* field) {
  if (!(finite(value, field) >= low)) {
    throw MessageError(std::string(field) + " is " + std::to_string(value) + ", must be at least " +
                       std::to_string(low));
  }
  return value;
}

void refuse(const std::string& why) { throw MessageError(why); }

}  // namespace regista
