// COMMANDS in, SSL simulation protocol out: each team to its port of one simulator or radio. Without fresh commands the
// robots are stopped. What the other side answers is reported.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "modules/ssl/command_relay.h"
#include "modules/ssl/socket_module.h"

class RobotControl;

namespace regista {

struct SslRadioParams {
  std::string host = "127.0.0.1";
  std::int64_t blue_port = 10301;    ///< the league's
  std::int64_t yellow_port = 10302;  ///< the league's
  std::string teams = "both";        ///< which are driven
  bool operator==(const SslRadioParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("host", self.host, Range{}, "", "name or IPv4 address of the simulator or radio");
    v("blue_port", self.blue_port, Range{1, 65535}, "", "UDP port that takes the blue team's commands");
    v("yellow_port", self.yellow_port, Range{1, 65535}, "", "UDP port that takes the yellow team's commands");
    v("teams", self.teams, Range{}, "", "which teams are driven: both, yellow or blue");
  }
};

class SslRadioModule : public SocketModule {
 public:
  /// Asks the name service for the host. Throws SocketError, or ParamError for other teams than both, yellow, blue.
  SslRadioModule(Bus& bus, const SslRadioParams& params);
  /// Stops the robots driven last.
  ~SslRadioModule() override;

  std::optional<Time> due() const override;
  std::string note() const override;

  /// Answers taken; answers and commands refused.
  const Reception& reception() const { return reception_; }

 protected:
  bool has_input() const override;
  void on_tick(Time now) override;
  std::vector<const UdpSocket*> sockets() const override;

 private:
  struct Link {
    Team team;
    Mailbox<TeamCommands> commands;
    UdpSocket socket;
    CommandRelay relay;
    std::string peer;                     ///< "127.0.0.1:10301"
    std::optional<Time> refused_at = {};  ///< nobody listened there
    std::string send_error = {};          ///< of the last datagram, empty where it went out
  };

  std::unique_ptr<Link> make_link(Team team, std::int64_t port);
  void change(const SslRadioParams& changed);
  bool drives(Team team) const;
  void receive(Link& link, Time now);
  void take_answer(const Link& link, std::span<const std::uint8_t> bytes, Time now);
  void report(const std::string& error, Time now);
  void command(Link& link, Time now);
  void forward(Link& link, const std::vector<RobotCommand>& commands, Time now);
  static void send(Link& link, const ::RobotControl& control);
  void refuse(const std::string& why);
  std::string note_of(const Link& link) const;

  SslRadioParams params_;
  Reception reception_;
  std::array<std::unique_ptr<Link>, 2> links_;  ///< both teams': one not driven hears that somebody is there
  std::string last_error_;                      ///< of the other side
  Time error_at_{};
  std::optional<Time> logged_at_;
  std::int64_t errors_not_logged_ = 0;
};

}  // namespace regista
