// What goes wrong with sockets and interfaces, for the one who started the program.
#pragma once

#include <stdexcept>

namespace regista {

/// The network refused; what() is one line that says what to do.
struct SocketError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace regista
