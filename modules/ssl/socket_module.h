// A module that hears the bus and sockets of its own, and the loop that waits for all of them at once, so that a packet
// is taken when it comes in and nothing spins.
#pragma once

#include <functional>
#include <vector>

#include "modules/bus/module.h"
#include "modules/process/process_loop.h"
#include "modules/ssl/udp_socket.h"

namespace regista {

class SocketModule : public Module {
 public:
  using Module::Module;

  /// What a process waits on: the bus and the sockets.
  std::vector<int> descriptors() const;

  Time now() const { return bus().now(); }

 protected:
  virtual std::vector<const UdpSocket*> sockets() const = 0;
  bool has_packets() const;
};

/// For ModuleProgram::run of a program whose module is a SocketModule.
void run_socket_module(Module& module, ProcessLoop& loop, const std::function<bool()>& stopped);

}  // namespace regista
