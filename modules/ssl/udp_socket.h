// A non-blocking UDP socket over IPv4: a receiver of a multicast group, or a line to one peer.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modules/ssl/socket_error.h"

namespace regista {

class UdpSocket {
 public:
  /// Receives what is sent to the group. interface is a name ("eth0"), an address of this machine, or empty: every
  /// interface that is up. Several receivers may share a port. Throws SocketError.
  static UdpSocket multicast_receiver(const std::string& group, std::uint16_t port, const std::string& interface);

  /// Sends to one peer and receives only its answers. May ask the name service, which takes its time.
  /// Throws SocketError.
  static UdpSocket to_peer(const std::string& host, std::uint16_t port);

  ~UdpSocket();
  UdpSocket(UdpSocket&& other) noexcept;
  UdpSocket& operator=(UdpSocket&& other) noexcept;

  int descriptor() const { return descriptor_; }

  /// receive() has something to do.
  bool readable() const;

  /// The next datagram, valid until the next call; nullopt when none is waiting. Throws SocketError.
  std::optional<std::span<const std::uint8_t>> receive();

  /// False when the datagram could not be handed to the network; last_error() says why.
  bool send(std::span<const std::uint8_t> bytes);
  const std::string& last_error() const { return last_error_; }

  /// Since the last call the peer's machine has said that nobody listens at that port.
  bool take_refusal();

 private:
  UdpSocket();

  int descriptor_ = -1;
  bool refused_ = false;
  std::string last_error_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace regista
