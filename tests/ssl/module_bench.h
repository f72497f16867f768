// A module on a bus of its own, with a clock that the test sets.
#pragma once

#include <functional>

#include "modules/bus/module.h"
#include "tests/support/program.h"

namespace regista {

struct TestBus {
  Time now = from_us(1'000'000);
  Bus bus{"memq://", [this] { return now; }};

  /// Lets the module work until the condition holds, as long as the network may reasonably need; true when it holds.
  bool run(Module& module, const std::function<bool()>& condition) {
    return eventually([&] {
      while (bus.handle(Duration::zero())) {
      }
      if (module.ready() || (module.due() && now >= *module.due())) module.tick(now);
      while (bus.handle(Duration::zero())) {
      }
      return condition();
    });
  }
};

}  // namespace regista
