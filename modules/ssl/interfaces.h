// The machine's network interfaces, for choosing where a multicast group is joined.
#pragma once

#include <string>
#include <vector>

namespace regista {

struct Interface {
  std::string name;
  int index = 0;  ///< the system's number for it
};

/// The interface of that name or IPv4 address; all that are up and have an IPv4 address where it is empty.
/// Throws SocketError naming those that are there.
std::vector<Interface> multicast_interfaces(const std::string& name_or_address);

}  // namespace regista
