// An X server of a test's own, without a screen (Xvfb): for programs that open windows.
#pragma once

#include <string>

#include "tests/support/program.h"

namespace regista {

class VirtualDisplay {
 public:
  static constexpr int kWidth_px = 1280;
  static constexpr int kHeight_px = 800;

  /// Waits until the server takes clients. Throws with the server's words when it does not come up.
  VirtualDisplay();

  /// As in the variable DISPLAY: ":7". The server chose the number.
  const std::string& name() const { return name_; }

 private:
  Program server_;
  std::string name_;
};

}  // namespace regista
