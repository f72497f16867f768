#include "modules/ssl/socket_module.h"

#include <poll.h>

#include <algorithm>
#include <ctime>

namespace regista {
namespace {

// A signal that comes just before the wait is seen after it at the latest.
constexpr Duration kLongestWait = std::chrono::milliseconds(100);

Duration time_to_wait(const Module& module, Time now) {
  if (module.ready()) return Duration::zero();
  const auto due = module.due();
  return due ? std::clamp(Duration{*due - now}, Duration::zero(), kLongestWait) : kLongestWait;
}

/// Until one of them is readable, or the time is over, or a signal comes.
void wait_for_any(const std::vector<int>& descriptors, Duration longest) {
  std::vector<pollfd> waiting;
  waiting.reserve(descriptors.size());
  for (const int descriptor : descriptors) waiting.push_back({descriptor, POLLIN, 0});
  const timespec timeout{longest.count() / 1'000'000, longest.count() % 1'000'000 * 1'000};
  ppoll(waiting.data(), waiting.size(), &timeout, nullptr);
}

}  // namespace

std::vector<int> SocketModule::descriptors() const {
  std::vector<int> out{bus().file_descriptor()};
  for (const UdpSocket* socket : sockets()) out.push_back(socket->descriptor());
  return out;
}

bool SocketModule::has_packets() const {
  const auto all = sockets();
  return std::any_of(all.begin(), all.end(), [](const UdpSocket* socket) { return socket->readable(); });
}

void run_socket_module(Module& module, ProcessLoop& loop, const std::function<bool()>& stopped) {
  const auto& with_sockets = dynamic_cast<const SocketModule&>(module);
  while (!stopped()) {
    wait_for_any(with_sockets.descriptors(), time_to_wait(module, with_sockets.now()));
    loop.step(Duration::zero());
  }
}

}  // namespace regista
