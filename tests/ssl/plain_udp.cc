#include "tests/ssl/plain_udp.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>
#include <vector>

namespace regista {
namespace {

void check(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

}  // namespace

MulticastSender::MulticastSender(const std::string& group, std::uint16_t port)
    : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  const unsigned char ttl = 0;
  const unsigned char loop = 1;
  in_addr loopback{};
  loopback.s_addr = htonl(INADDR_LOOPBACK);
  check(setsockopt(descriptor_, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl) == 0, "TTL");
  check(setsockopt(descriptor_, IPPROTO_IP, IP_MULTICAST_LOOP, &loop, sizeof loop) == 0, "loop");
  check(setsockopt(descriptor_, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback) == 0, "interface");
  group_.sin_family = AF_INET;
  group_.sin_port = htons(port);
  check(inet_pton(AF_INET, group.c_str(), &group_.sin_addr) == 1, "group");
}

MulticastSender::~MulticastSender() { close(descriptor_); }

void MulticastSender::send(const std::string& bytes) const {
  const auto* address = reinterpret_cast<const sockaddr*>(&group_);
  check(sendto(descriptor_, bytes.data(), bytes.size(), 0, address, sizeof group_) >= 0, "sending to the group failed");
}

UdpServer::UdpServer() : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in local{};
  local.sin_family = AF_INET;
  local.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  check(bind(descriptor_, reinterpret_cast<const sockaddr*>(&local), sizeof local) == 0, "bind");
}

UdpServer::~UdpServer() { close(descriptor_); }

std::uint16_t UdpServer::port() const {
  sockaddr_in local{};
  socklen_t size = sizeof local;
  check(getsockname(descriptor_, reinterpret_cast<sockaddr*>(&local), &size) == 0, "getsockname");
  return ntohs(local.sin_port);
}

std::optional<std::string> UdpServer::receive(int timeout_ms) {
  pollfd waiting{descriptor_, POLLIN, 0};
  if (poll(&waiting, 1, timeout_ms) <= 0) return std::nullopt;
  std::vector<char> buffer(65536);
  socklen_t size = sizeof last_sender_;
  const ssize_t got =
      recvfrom(descriptor_, buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&last_sender_), &size);
  check(got >= 0, "recvfrom");
  return std::string(buffer.data(), static_cast<std::size_t>(got));
}

void UdpServer::answer(const std::string& bytes) const {
  const auto* address = reinterpret_cast<const sockaddr*>(&last_sender_);
  check(sendto(descriptor_, bytes.data(), bytes.size(), 0, address, sizeof last_sender_) >= 0, "answering failed");
}

std::string private_group() { return "224.5.23." + std::to_string(200 + getpid() % 50); }
std::uint16_t private_port() { return static_cast<std::uint16_t>(20000 + getpid() % 6000); }

}  // namespace regista
