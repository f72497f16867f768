#include "logs/log_reader.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <lcm/lcm-cpp.hpp>

namespace regista {
namespace {

// LCM's log format: sync word 4, event number 8, time 8, channel length 4, data length 4.
constexpr std::size_t kEventHeaderBytes = 28;

}  // namespace

std::optional<Time> stamp_of(const std::vector<std::uint8_t>& bytes) {
  constexpr std::size_t kStampAt = 8;  // behind the fingerprint
  constexpr std::size_t kStampBytes = 8;
  if (bytes.size() < kStampAt + kStampBytes) return std::nullopt;
  std::uint64_t stamp = 0;
  for (std::size_t i = kStampAt; i < kStampAt + kStampBytes; ++i) stamp = stamp << 8 | bytes[i];
  return from_us(static_cast<std::int64_t>(stamp));
}

LogReader::LogReader(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw LogError("no log " + file + ": give the file regista record wrote");
  if (!std::filesystem::is_regular_file(file, error)) throw LogError(file + " is no file: give a log");
  file_bytes_ = static_cast<std::int64_t>(std::filesystem::file_size(file));
  log_ = std::make_unique<lcm::LogFile>(file, "r");
  if (!log_->good()) throw LogError("cannot read log " + file + ": " + std::strerror(errno));
}

LogReader::~LogReader() = default;

std::optional<LogMessage> LogReader::next() {
  const lcm::LogEvent* event = log_->readNextEvent();
  // LCM gives up at an event whose header makes no sense; the next one may be whole again.
  while (event == nullptr && std::feof(log_->getFilePtr()) == 0 && std::ferror(log_->getFilePtr()) == 0) {
    event = log_->readNextEvent();
  }
  if (event == nullptr) return std::nullopt;
  LogMessage message{from_us(event->timestamp), event->channel, {}};
  const auto* data = static_cast<const std::uint8_t*>(event->data);
  message.bytes.assign(data, data + event->datalen);
  message_bytes_ += static_cast<std::int64_t>(kEventHeaderBytes + message.channel.size() + message.bytes.size());
  return message;
}

void require_message(const std::string& file) {
  if (!LogReader(file).next()) throw LogError(file + " holds no whole message: it is empty, damaged or no LCM log");
}

}  // namespace regista
