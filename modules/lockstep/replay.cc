#include "modules/lockstep/replay.h"

#include <filesystem>
#include <optional>
#include <regex>

namespace regista {
namespace {

/// The time of the first message: module clocks begin there.
Time begin_of(const std::string& url) {
  std::optional<Time> begin;
  Bus log(url, [] { return Time{}; });
  const auto tap = log.subscribe_raw(".*", [&](const std::string&, std::span<const std::uint8_t>) {
    if (!begin) begin = log.received_at();
  });
  while (!begin && log.handle(Duration::zero())) {
  }
  return begin.value_or(Time{});
}

}  // namespace

Replay replay_log(const std::string& log_file, const std::string& outputs,
                  const std::function<void(LockStep&)>& add_modules) {
  const std::string url = "file://" + std::filesystem::absolute(log_file).string() + "?speed=0";
  const std::regex output_channels(outputs);
  const auto is_output = [&](const std::string& channel) {
    return std::regex_match(channel, output_channels) && !channels::is_measured(channel);
  };

  Replay replay;
  LockStep loop(begin_of(url));
  const auto listener =
      loop.bus().subscribe_raw(".*", [&](const std::string& channel, std::span<const std::uint8_t> bytes) {
        if (is_output(channel)) replay.replayed.push_back({loop.now(), channel, {bytes.begin(), bytes.end()}});
      });
  add_modules(loop);

  Bus log(url, [] { return Time{}; });
  const auto player = log.subscribe_raw(".*", [&](const std::string& channel, std::span<const std::uint8_t> bytes) {
    loop.run_until(log.received_at());
    if (is_output(channel)) {
      replay.recorded.push_back({log.received_at(), channel, {bytes.begin(), bytes.end()}});
    } else {
      loop.inject(channel, bytes);
    }
  });
  while (log.handle(Duration::zero())) {
  }
  return replay;
}

}  // namespace regista
