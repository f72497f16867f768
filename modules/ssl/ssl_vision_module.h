// SSL-Vision multicast in, VISION and GEOMETRY out: one VISION per detection frame, whichever camera it is from;
// GEOMETRY when it changes and every second, however seldom the source sends it.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "modules/ssl/socket_module.h"
#include "world_model/types/field.h"

class SSL_WrapperPacket;

namespace regista {

struct SslVisionParams {
  std::string group = "224.5.23.2";   ///< the league's
  std::int64_t port = 10006;          ///< the league's; simulators by default 10020
  std::string interface;              ///< name or address; empty: all
  bool yellow_on_positive_x = false;  ///< the vision does not tell
  bool operator==(const SslVisionParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("group", self.group, Range{}, "", "multicast group of SSL-Vision");
    v("port", self.port, Range{1, 65535}, "", "UDP port: 10006 on fields, 10020 of most simulators");
    v("interface", self.interface, Range{}, "", "network interface, by name or address; empty: every one that is up");
    v("yellow_on_positive_x", self.yellow_on_positive_x, Range{}, "", "yellow defends the goal at +x");
  }
};

class SslVisionModule : public SocketModule {
 public:
  /// Throws SocketError.
  SslVisionModule(Bus& bus, const SslVisionParams& params);
  ~SslVisionModule() override;

  std::optional<Time> due() const override;
  std::string note() const override;

  /// Packets taken and refused.
  const Reception& reception() const { return reception_; }

  /// Robots without number or heading since the start.
  std::int64_t robots_skipped() const { return robots_skipped_; }

 protected:
  bool has_input() const override { return has_packets(); }
  void on_tick(Time now) override;
  std::vector<const UdpSocket*> sockets() const override { return {&socket_}; }

 private:
  void change(const SslVisionParams& changed);
  void take(std::span<const std::uint8_t> bytes, Time now);
  void hand_on(const SSL_WrapperPacket& packet, Time now);
  void announce(const FieldGeometry& field, Time now);

  SslVisionParams params_;
  UdpSocket socket_;
  Reception reception_;
  std::optional<Time> last_packet_;  ///< arrival of the newest well-formed one
  std::optional<FieldGeometry> field_;
  Time announced_{};  ///< when field_ was last published
  std::int64_t robots_skipped_ = 0;
  std::int64_t skipped_in_last_frame_ = 0;
};

}  // namespace regista
