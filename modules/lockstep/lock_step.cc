#include "modules/lockstep/lock_step.h"

#include <algorithm>

namespace regista {

LockStep::LockStep(Time start) : now_(start), bus_("memq://", [this] { return now_; }) {}

void LockStep::remove(const Module& module) {
  std::erase_if(modules_, [&](const std::unique_ptr<Module>& kept) { return kept.get() == &module; });
}

void LockStep::drain() {
  while (bus_.handle(Duration::zero())) {
    for (const auto& module : modules_) {
      if (module->ready()) module->tick(now_);
    }
  }
}

std::optional<Time> LockStep::next_due() const {
  std::optional<Time> next;
  for (const auto& module : modules_) {
    const auto due = module->due();
    if (due && (!next || *due < *next)) next = due;
  }
  return next;
}

void LockStep::inject(const std::string& channel, std::span<const std::uint8_t> bytes) {
  bus_.publish_raw(channel, bytes);
  drain();
}

void LockStep::run_until(Time end) {
  drain();
  for (auto next = next_due(); next && *next <= end; next = next_due()) {
    now_ = std::max(now_, *next);
    for (const auto& module : modules_) {
      const auto due = module->due();
      if (due && *due <= now_) module->tick(now_);
    }
    drain();
  }
  now_ = std::max(now_, end);
}

}  // namespace regista
