#include "modules/lockstep/replay.h"

#include <filesystem>
#include <regex>

namespace regista {
namespace {

/// A log as a bus (file://), with the times of its messages: LCM's own player passes on the moment of replay instead.
class TimedLog {
 public:
  using Handler = std::function<void(const LogMessage&)>;

  TimedLog(const std::string& file, Handler handler)
      : times_(file),
        next_(times_.next()),
        bus_("file://" + std::filesystem::absolute(file).string() + "?speed=0", [] { return Time{}; }),
        handler_(std::move(handler)) {
    player_ = bus_.subscribe_raw(".*", [this](const std::string& channel, std::span<const std::uint8_t> bytes) {
      const LogMessage message{next_.value().received, channel, {bytes.begin(), bytes.end()}};
      next_ = times_.next();
      handler_(message);
    });
  }

  Time begin() const { return next_ ? next_->received : Time{}; }
  void play() {
    while (bus_.handle(Duration::zero())) {
    }
  }

 private:
  LogReader times_;
  std::optional<LogMessage> next_;
  Bus bus_;
  Handler handler_;
  std::unique_ptr<Bus::Subscription> player_;
};

}  // namespace

Replay replay_log(const std::string& log_file, const std::string& outputs,
                  const std::function<void(LockStep&)>& add_modules) {
  const std::regex output_channels(outputs);
  const auto is_output = [&](const std::string& channel) {
    return std::regex_match(channel, output_channels) && !channels::is_measured(channel);
  };

  Replay replay;
  LockStep* modules = nullptr;
  TimedLog log(log_file, [&](const LogMessage& message) {
    modules->run_until(message.received);
    if (is_output(message.channel)) {
      replay.recorded.push_back(message);
    } else {
      modules->inject(message.channel, message.bytes);
    }
  });
  LockStep loop(log.begin());
  modules = &loop;
  const auto listener =
      loop.bus().subscribe_raw(".*", [&](const std::string& channel, std::span<const std::uint8_t> bytes) {
        if (is_output(channel)) replay.replayed.push_back({loop.now(), channel, {bytes.begin(), bytes.end()}});
      });
  add_modules(loop);
  log.play();
  return replay;
}

}  // namespace regista
