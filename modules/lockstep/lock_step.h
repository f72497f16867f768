// All modules in one thread over one memq:// bus on a simulated clock: a discrete-event loop. Messages are handed out
// one at a time, in the order they were published; after each, the modules that are ready tick, in the order they were
// added; when none is left the clock jumps to the next moment a module is due. Same modules, same messages: same run,
// bit for bit, as fast as the machine can.
#pragma once

#include <memory>
#include <vector>

#include "modules/bus/module.h"

namespace regista {

class LockStep {
 public:
  explicit LockStep(Time start);

  Bus& bus() { return bus_; }
  Time now() const { return now_; }

  /// Makes a module on this loop's bus and keeps it. Returns it.
  template <class M, class... Args>
  M& add(Args&&... args) {
    auto module = std::make_unique<M>(bus_, std::forward<Args>(args)...);
    M& added = *module;
    modules_.push_back(std::move(module));
    return added;
  }

  /// The module is gone from the next message on, as when its process dies. Precondition: it was added here.
  void remove(const Module& module);

  /// Hands a message in at the present time and lets the modules answer it.
  void inject(const std::string& channel, std::span<const std::uint8_t> bytes);

  /// Handles all that happens up to and including `end`, then leaves the clock there.
  void run_until(Time end);

 private:
  void drain();
  std::optional<Time> next_due() const;

  Time now_;
  Bus bus_;
  std::vector<std::unique_ptr<Module>> modules_;
};

}  // namespace regista
