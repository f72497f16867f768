#include "modules/ssl/udp_socket.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "modules/ssl/interfaces.h"

namespace regista {
namespace {

constexpr std::size_t kLargestDatagram = 65536;  // UDP's length field
constexpr int kReceiveQueueBytes = 1 << 20;      // a second of four cameras; the system may grant less

std::string reason() { return std::strerror(errno); }

sockaddr_in address_of(in_addr address, std::uint16_t port) {
  sockaddr_in out{};
  out.sin_family = AF_INET;
  out.sin_addr = address;
  out.sin_port = htons(port);
  return out;
}

void set_option(int descriptor, int level, int option, int value) {
  // Only comforts are set this way: a system that refuses one still works.
  setsockopt(descriptor, level, option, &value, sizeof value);
}

in_addr multicast_group(const std::string& group) {
  in_addr address{};
  if (inet_pton(AF_INET, group.c_str(), &address) != 1 || !IN_MULTICAST(ntohl(address.s_addr))) {
    throw SocketError("'" + group + "' is no IPv4 multicast address, give one like 224.5.23.2");
  }
  return address;
}

/// Throws where not one of the interfaces lets the socket join.
void join(int descriptor, in_addr group, const std::vector<Interface>& interfaces) {
  bool joined = false;
  std::string why = "this machine has no network interface that is up";
  for (const Interface& interface : interfaces) {
    ip_mreqn request{};
    request.imr_multiaddr = group;
    request.imr_ifindex = interface.index;
    if (setsockopt(descriptor, IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof request) == 0) {
      joined = true;
    } else {
      why = interface.name + ": " + reason();
    }
  }
  if (!joined) throw SocketError("cannot join the multicast group (" + why + "), choose another interface");
}

in_addr resolve(const std::string& host) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const int status = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  if (status != 0 || found == nullptr) {
    throw SocketError("cannot find the host '" + host + "' (" + gai_strerror(status) +
                      "), give a name or IPv4 address that this machine can reach");
  }
  sockaddr_in address{};
  std::memcpy(&address, found->ai_addr, sizeof address);
  freeaddrinfo(found);
  return address.sin_addr;
}

}  // namespace

UdpSocket::UdpSocket()
    : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)), buffer_(kLargestDatagram) {
  if (descriptor_ < 0) throw SocketError("cannot open a UDP socket: " + reason());
}

UdpSocket::~UdpSocket() {
  if (descriptor_ >= 0) close(descriptor_);
}

UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      refused_(other.refused_),
      last_error_(std::move(other.last_error_)),
      buffer_(std::move(other.buffer_)) {}

UdpSocket& UdpSocket::operator=(UdpSocket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(refused_, other.refused_);
  std::swap(last_error_, other.last_error_);
  std::swap(buffer_, other.buffer_);
  return *this;
}

UdpSocket UdpSocket::multicast_receiver(const std::string& group, std::uint16_t port, const std::string& interface) {
  const in_addr address = multicast_group(group);
  UdpSocket out;
  set_option(out.descriptor_, SOL_SOCKET, SO_REUSEADDR, 1);
  set_option(out.descriptor_, SOL_SOCKET, SO_RCVBUF, kReceiveQueueBytes);
  // Linux would also deliver what other programs have joined on other interfaces.
  set_option(out.descriptor_, IPPROTO_IP, IP_MULTICAST_ALL, 0);
  // Bound to the group, not to any address: other groups on the same port stay out.
  const sockaddr_in local = address_of(address, port);
  if (bind(out.descriptor_, reinterpret_cast<const sockaddr*>(&local), sizeof local) != 0) {
    throw SocketError("cannot listen at " + group + ":" + std::to_string(port) + ": " + reason());
  }
  join(out.descriptor_, address, multicast_interfaces(interface));
  return out;
}

UdpSocket UdpSocket::to_peer(const std::string& host, std::uint16_t port) {
  const sockaddr_in peer = address_of(resolve(host), port);
  UdpSocket out;
  if (connect(out.descriptor_, reinterpret_cast<const sockaddr*>(&peer), sizeof peer) != 0) {
    throw SocketError("cannot reach " + host + ":" + std::to_string(port) + ": " + reason());
  }
  return out;
}

bool UdpSocket::readable() const {
  pollfd waiting{descriptor_, POLLIN, 0};
  return poll(&waiting, 1, 0) > 0;
}

std::optional<std::span<const std::uint8_t>> UdpSocket::receive() {
  while (true) {
    const ssize_t size = recv(descriptor_, buffer_.data(), buffer_.size(), 0);
    if (size >= 0) return std::span<const std::uint8_t>(buffer_.data(), static_cast<std::size_t>(size));
    if (errno == EAGAIN || errno == EWOULDBLOCK) return std::nullopt;
    if (errno == ECONNREFUSED) {
      refused_ = true;
    } else if (errno != EINTR) {
      throw SocketError("receiving failed: " + reason());
    }
  }
}

bool UdpSocket::send(std::span<const std::uint8_t> bytes) {
  // A refusal reported here is an earlier datagram's, and this one has not been sent yet: once more.
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0) return true;
    if (errno != ECONNREFUSED) break;
    refused_ = true;
  }
  last_error_ = reason();
  return false;
}

bool UdpSocket::take_refusal() { return std::exchange(refused_, false); }

}  // namespace regista
