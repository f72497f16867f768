#include "modules/ssl/ssl_radio_module.h"

#include <spdlog/spdlog.h>

#include "modules/convert/commands.h"
#include "modules/convert/common.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_radio_convert.h"
#include "ssl_simulation_control.pb.h"
#include "ssl_simulation_response.pb.h"

namespace regista {
namespace {

constexpr int kAnswersPerTick = 64;                           // the commands wait for no flood of answers
constexpr Duration kLogEvery = std::chrono::seconds(1);       // a simulator repeats its complaint with every command
constexpr Duration kErrorIsNews = std::chrono::seconds(10);   // long enough for a person to read it in the table
constexpr Duration kRefusalIsNews = std::chrono::seconds(1);  // it comes back with every datagram until it is cured

void check_teams(const std::string& teams) {
  if (teams != "both" && teams != "yellow" && teams != "blue") {
    throw ParamError("teams is '" + teams + "', must be both, yellow or blue");
  }
}

}  // namespace

SslRadioModule::SslRadioModule(Bus& bus, const SslRadioParams& params)
    : SocketModule("ssl-radio", bus), params_(params) {
  check_teams(params.teams);
  links_ = {make_link(Team::yellow, params.yellow_port), make_link(Team::blue, params.blue_port)};
  bus.enroll(&reception_);
  expose<SslRadioParams>(params_, [this](const SslRadioParams& changed) { change(changed); });
}

SslRadioModule::~SslRadioModule() {
  for (const auto& link : links_) {
    if (const auto stops = link->relay.idle(now()); !stops.empty()) send(*link, to_robot_control(stops));
  }
  bus().dismiss(&reception_);
}

std::unique_ptr<SslRadioModule::Link> SslRadioModule::make_link(Team team, std::int64_t port) {
  return std::unique_ptr<Link>(new Link{team,
                                        {bus(), channels::commands(team)},
                                        UdpSocket::to_peer(params_.host, static_cast<std::uint16_t>(port)),
                                        CommandRelay(now()),
                                        params_.host + ":" + std::to_string(port)});
}

void SslRadioModule::change(const SslRadioParams& changed) {
  check_teams(changed.teams);
  SslRadioParams same_peer = changed;
  same_peer.teams = params_.teams;
  // The name service may take seconds, in which no robot would be stopped.
  if (same_peer != params_) throw RequestRefused("host and ports are set at the start: --set ssl_radio.host=…");
  params_ = changed;
}

bool SslRadioModule::drives(Team team) const { return params_.teams == "both" || params_.teams == regista::name(team); }

std::vector<const UdpSocket*> SslRadioModule::sockets() const { return {&links_[0]->socket, &links_[1]->socket}; }

bool SslRadioModule::has_input() const {
  return links_[0]->commands.fresh() || links_[1]->commands.fresh() || has_packets();
}

std::optional<Time> SslRadioModule::due() const { return std::min(links_[0]->relay.due(), links_[1]->relay.due()); }

void SslRadioModule::on_tick(Time now) {
  for (const auto& link : links_) {
    command(*link, now);
    receive(*link, now);
  }
}

void SslRadioModule::command(Link& link, Time now) {
  if (link.commands.fresh()) {
    const TeamCommands& newest = *link.commands.take();
    try {
      require(newest.team == link.team, "it carries the other team's commands");
      if (drives(link.team)) forward(link, newest.commands, now);
    } catch (const MessageError& error) {
      refuse(channels::commands(link.team).name + " refused: " + error.what());
    }
  }
  if (now >= link.relay.due()) send(link, to_robot_control(link.relay.idle(now)));
}

void SslRadioModule::forward(Link& link, const std::vector<RobotCommand>& commands, Time now) {
  // Converted first: commands that are refused must not keep the relay from stopping the robots.
  ::RobotControl control = to_robot_control(commands);
  control.MergeFrom(to_robot_control(link.relay.beside(commands, now)));
  send(link, control);
}

void SslRadioModule::send(Link& link, const ::RobotControl& control) {
  const std::string bytes = control.SerializeAsString();
  const bool sent = link.socket.send({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  link.send_error = sent ? "" : link.socket.last_error();
}

void SslRadioModule::receive(Link& link, Time now) {
  for (int i = 0; i < kAnswersPerTick; ++i) {
    const auto bytes = link.socket.receive();
    if (!bytes) break;
    take_answer(link, *bytes, now);
  }
  if (link.socket.take_refusal()) link.refused_at = now;
}

void SslRadioModule::take_answer(const Link& link, std::span<const std::uint8_t> bytes, Time now) {
  try {
    const auto response = parse_packet<::RobotControlResponse>(bytes);
    ++reception_.received;
    for (const std::string& line : error_lines(response))
      report(std::string(regista::name(link.team)) + ": " + line, now);
  } catch (const MessageError& error) {
    refuse("answer of " + std::to_string(bytes.size()) + " bytes from " + link.peer + " refused: " + error.what());
  }
}

void SslRadioModule::report(const std::string& error, Time now) {
  last_error_ = error;
  error_at_ = now;
  ++errors_not_logged_;
  if (logged_at_ && now - *logged_at_ < kLogEvery) return;
  spdlog::warn("{}: {} reports {} (errors since the last such line: {})", name(), params_.host, error,
               errors_not_logged_);
  logged_at_ = now;
  errors_not_logged_ = 0;
}

void SslRadioModule::refuse(const std::string& why) {
  ++reception_.refused;
  reception_.last_refusal = why;
}

std::string SslRadioModule::note_of(const Link& link) const {
  if (!link.send_error.empty()) return "cannot send to " + link.peer + ": " + link.send_error;
  if (link.refused_at && now() - *link.refused_at <= kRefusalIsNews) {
    return "nobody listens at " + link.peer + " (" + regista::name(link.team) + ")";
  }
  if (drives(link.team) && link.commands.newest() == nullptr) {
    return "waiting for " + channels::commands(link.team).name;
  }
  return {};
}

std::string SslRadioModule::note() const {
  if (!last_error_.empty() && now() - error_at_ <= kErrorIsNews) return last_error_;
  for (const auto& link : links_) {
    if (std::string text = note_of(*link); !text.empty()) return text;
  }
  return {};
}

}  // namespace regista
