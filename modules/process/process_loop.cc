#include "modules/process/process_loop.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "modules/process/percentiles.h"

namespace regista {
namespace {

constexpr Duration kReportEvery = std::chrono::seconds(1);
constexpr int kMostPerStep = 10'000;  // many ticks' worth of messages

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "?";
}

}  // namespace

ProcessLoop::ProcessLoop(Module& module, Bus& bus, Stopwatch stopwatch)
    : module_(module),
      bus_(bus),
      stopwatch_(std::move(stopwatch)),
      host_(host_name()),
      started_(bus.now()),
      reported_(started_) {}

void ProcessLoop::step(Duration max_wait) {
  const Time now = bus_.now();
  Duration wait = std::min(max_wait, reported_ + kReportEvery - now);
  if (const auto due = module_.due()) wait = std::min(wait, *due - now);
  // Everything that has come in, but not for ever: a publisher faster than this process must not keep it from ticking.
  bool more = bus_.handle(wait);
  for (int taken = 1; more && taken < kMostPerStep; ++taken) more = bus_.handle(Duration::zero());
  const Time tick_at = bus_.now();
  const auto due = module_.due();
  if (module_.ready() || (due && tick_at >= *due)) {
    const std::int64_t begin_ns = stopwatch_();
    module_.tick(tick_at);
    tick_times_ns_.push_back(stopwatch_() - begin_ns);
  }
  report_refusal();
  report_if_due();
}

void ProcessLoop::report_refusal() {
  const Reception reception = bus_.reception();
  if (reception.refused == refusals_logged_) return;
  // The first, then at every doubling: a babbling neighbour must not fill the disk.
  if (reception.refused >= 2 * refusals_logged_) {
    spdlog::warn("{}: {} ({} refused so far)", module_.name(), reception.last_refusal, reception.refused);
    refusals_logged_ = reception.refused;
  }
}

void ProcessLoop::report_if_due() {
  const Time now = bus_.now();
  if (now - reported_ < kReportEvery) return;
  const Percentiles ticks = percentiles(std::move(tick_times_ns_));
  const Reception reception = bus_.reception();
  ModuleStatus status;
  status.sent = now;
  status.module = module_.name();
  status.host = host_;
  status.pid = getpid();
  status.uptime = now - started_;
  status.rate_hz = static_cast<double>(ticks.count) / to_seconds(now - reported_);
  status.tick_p50_ns = ticks.p50_ns;
  status.tick_p99_ns = ticks.p99_ns;
  status.received = reception.received;
  status.skipped = reception.skipped;
  status.refused = reception.refused;
  status.parameters_fingerprint = module_.parameters_fingerprint();
  // A refusal is news for one report; the count stays.
  const bool refused_lately = reception.refused > refused_reported_;
  refused_reported_ = reception.refused;
  status.note = refused_lately ? reception.last_refusal : module_.note();
  bus_.publish(channels::status(module_.name()), status);
  tick_times_ns_.clear();
  reported_ = now;
}

}  // namespace regista
