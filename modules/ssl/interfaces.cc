#include "modules/ssl/interfaces.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "modules/ssl/socket_error.h"

namespace regista {
namespace {

struct Address {
  Interface interface;
  std::string ipv4;
};

std::string ipv4_of(const sockaddr& address) {
  sockaddr_in in{};
  std::memcpy(&in, &address, sizeof in);
  std::array<char, INET_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET, &in.sin_addr, text.data(), text.size()) != nullptr ? text.data() : "";
}

std::vector<Address> addresses_up() {
  std::vector<Address> out;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return out;
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET || (one->ifa_flags & IFF_UP) == 0) continue;
    out.push_back({{one->ifa_name, static_cast<int>(if_nametoindex(one->ifa_name))}, ipv4_of(*one->ifa_addr)});
  }
  freeifaddrs(all);
  return out;
}

}  // namespace

std::vector<Interface> multicast_interfaces(const std::string& name_or_address) {
  std::vector<Interface> chosen;
  std::string known;
  for (const Address& address : addresses_up()) {
    known += (known.empty() ? "" : ", ") + address.interface.name + " (" + address.ipv4 + ")";
    const bool wanted =
        name_or_address.empty() || name_or_address == address.interface.name || name_or_address == address.ipv4;
    const bool there = std::any_of(chosen.begin(), chosen.end(),
                                   [&](const Interface& one) { return one.index == address.interface.index; });
    if (wanted && !there) chosen.push_back(address.interface);
  }
  if (chosen.empty() && !name_or_address.empty()) {
    throw SocketError("no network interface '" + name_or_address + "', there are: " + known);
  }
  return chosen;
}

}  // namespace regista
