// The league's referee multicast in, REFEREE out: one message per packet, several times a second.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "modules/ssl/socket_module.h"

namespace regista {

struct SslRefereeParams {
  std::string group = "224.5.23.1";  ///< the league's
  std::int64_t port = 10003;         ///< the league's
  std::string interface;             ///< name or address; empty: all
  bool operator==(const SslRefereeParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("group", self.group, Range{}, "", "multicast group of the referee");
    v("port", self.port, Range{1, 65535}, "", "UDP port of the referee");
    v("interface", self.interface, Range{}, "", "network interface, by name or address; empty: every one that is up");
  }
};

class SslRefereeModule : public SocketModule {
 public:
  /// Throws SocketError.
  SslRefereeModule(Bus& bus, const SslRefereeParams& params);
  ~SslRefereeModule() override;

  std::string note() const override;

  /// Packets taken and refused.
  const Reception& reception() const { return reception_; }

 protected:
  bool has_input() const override { return has_packets(); }
  void on_tick(Time now) override;
  std::vector<const UdpSocket*> sockets() const override { return {&socket_}; }

 private:
  void change(const SslRefereeParams& changed);
  void take(std::span<const std::uint8_t> bytes, Time now);

  SslRefereeParams params_;
  UdpSocket socket_;
  Reception reception_;
  std::optional<Time> last_packet_;  ///< arrival of the newest well-formed one
  std::string last_command_;         ///< in it, as command_text has it
};

}  // namespace regista
