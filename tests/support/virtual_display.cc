#include "tests/support/virtual_display.h"

#include <stdexcept>

namespace regista {
namespace {

/// It writes its number to stdout once it listens.
std::vector<std::string> server_command() {
  const std::string screen =
      std::to_string(VirtualDisplay::kWidth_px) + "x" + std::to_string(VirtualDisplay::kHeight_px) + "x24";
  return {"Xvfb", "-displayfd", "1", "-screen", "0", screen, "-nolisten", "tcp"};
}

}  // namespace

VirtualDisplay::VirtualDisplay() : server_(server_command()) {
  const auto has_number = [this] { return server_.out().ends_with('\n'); };
  eventually([&] { return has_number() || !is_alive(server_.pid()); });
  if (!has_number()) throw std::runtime_error("Xvfb does not come up: " + server_.error());
  const std::string number = server_.out();
  name_ = ":" + number.substr(0, number.size() - 1);
}

}  // namespace regista
