#include "modules/viewer/snapshot.h"

#include <algorithm>

namespace regista {
namespace {

constexpr Duration kSilence = std::chrono::seconds(10);
// Without --at: what has come in until then is all there is.
constexpr Duration kEnough = std::chrono::seconds(2);
// The graph comes at 10 Hz, the last thing that is missing.
constexpr Duration kGraphGrace = std::chrono::milliseconds(300);
constexpr Duration kLongestWait = std::chrono::milliseconds(50);
// A log at full speed always has the next message ready: nothing within this time is the end.
constexpr Duration kLogEnd = std::chrono::seconds(1);

void check_stopped(const std::function<bool()>& stopped) {
  if (stopped()) throw SnapshotError("stopped before the picture was due");
}

}  // namespace

bool SnapshotTrigger::due(bool heard, bool complete, Time now) {
  if (!heard) return false;
  heard_at_ = std::min(heard_at_, now);
  if (at_) return to_seconds(now - heard_at_) >= *at_;
  if (complete) complete_at_ = std::min(complete_at_, now);
  if (now - heard_at_ >= kEnough) return true;
  return complete_at_ <= now && now - complete_at_ >= kGraphGrace;
}

void await_picture(ViewerModule& module, ProcessLoop& loop, const Bus& bus, SnapshotTrigger& trigger,
                   const std::string& url, const std::function<bool()>& stopped) {
  const Time begin = bus.now();
  do {
    check_stopped(stopped);
    if (!module.heard() && bus.now() - begin > kSilence) {
      throw SnapshotError("no message within 10 s on " + url +
                          ": start the other modules, or name their bus by --lcm-url");
    }
    loop.step(kLongestWait);
  } while (!trigger.due(module.heard(), module.complete(), bus.now()));
}

bool play_next(ViewerModule& module, Bus& bus) {
  if (!bus.handle(kLogEnd)) return false;
  if (module.ready()) module.tick(bus.now());
  return true;
}

void play_until_picture(ViewerModule& module, Bus& bus, SnapshotTrigger& trigger, const std::string& url,
                        const std::function<bool()>& stopped) {
  std::optional<Time> seen;
  while (play_next(module, bus)) {
    check_stopped(stopped);
    const std::optional<Time> now = module.world_time();
    if (!now || now == seen) continue;
    seen = now;
    if (trigger.due(true, module.complete(), *now)) return;
  }
  if (!module.world_time()) throw SnapshotError("nothing to see in the log " + url + ": it holds no world state");
}

bool is_log(const std::string& url) { return url.starts_with("file:"); }

std::string at_full_speed(const std::string& url) {
  if (!is_log(url) || url.find("speed=") != std::string::npos) return url;
  return url + (url.find('?') == std::string::npos ? "?speed=0" : "&speed=0");
}

}  // namespace regista
