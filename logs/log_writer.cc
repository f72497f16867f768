#include "logs/log_writer.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <lcm/lcm-cpp.hpp>
#include <limits>

namespace regista {
namespace {

constexpr std::size_t kLongestChannel = 999;  // what LCM's own reader accepts

}  // namespace

LogWriter::LogWriter(const std::string& file) : file_(file), log_(std::make_unique<lcm::LogFile>(file, "w")) {
  if (!log_->good()) fail();
}

LogWriter::~LogWriter() = default;

void LogWriter::write(Time received, const std::string& channel, std::span<const std::uint8_t> bytes) {
  if (!log_) throw LogError("log " + file_ + " is closed");
  if (channel.empty() || channel.size() > kLongestChannel) {
    throw LogError("log " + file_ + ": a channel name has 1 to 999 bytes, not " + std::to_string(channel.size()));
  }
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw LogError("log " + file_ + ": a message of " + std::to_string(bytes.size()) + " bytes is too long");
  }
  errno = 0;
  lcm::LogEvent event{};
  event.timestamp = to_us(received);
  event.channel = channel;
  event.datalen = static_cast<std::int32_t>(bytes.size());
  // LCM's interface is not const-correct; writeEvent only reads the data.
  event.data = const_cast<std::uint8_t*>(bytes.data());
  if (log_->writeEvent(&event) != 0) fail();
}

void LogWriter::close() {
  if (!log_) return;
  errno = 0;
  if (std::fflush(log_->getFilePtr()) != 0 || std::ferror(log_->getFilePtr()) != 0) fail();
  log_.reset();
}

void LogWriter::fail() const {
  throw LogError("cannot write log " + file_ + ": " + (errno != 0 ? std::strerror(errno) : "the disk refuses"));
}

}  // namespace regista
