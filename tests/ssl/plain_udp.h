// Plain UDP sockets for tests: the other side of the modules, made without their code.
#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <optional>
#include <string>

namespace regista {

/// Sends datagrams to a multicast group on the loopback interface with TTL 0: they never leave this machine.
class MulticastSender {
 public:
  MulticastSender(const std::string& group, std::uint16_t port);
  ~MulticastSender();
  MulticastSender(const MulticastSender&) = delete;
  MulticastSender& operator=(const MulticastSender&) = delete;
  void send(const std::string& bytes) const;

 private:
  int descriptor_;
  sockaddr_in group_{};
};

/// A simulator's port: takes datagrams and answers their sender.
class UdpServer {
 public:
  UdpServer();
  ~UdpServer();
  UdpServer(const UdpServer&) = delete;
  UdpServer& operator=(const UdpServer&) = delete;

  std::uint16_t port() const;
  /// The next datagram, waiting at most that long.
  std::optional<std::string> receive(int timeout_ms);
  /// To the sender of the last datagram received.
  void answer(const std::string& bytes) const;

 private:
  int descriptor_;
  sockaddr_in last_sender_{};
};

/// A group and a port that no other run uses, below those that the system hands out (Linux: from 32768).
std::string private_group();
std::uint16_t private_port();

}  // namespace regista
