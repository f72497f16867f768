#include "modules/ssl/ssl_referee_module.h"

#include "modules/convert/referee.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_referee_convert.h"
#include "ssl_referee.pb.h"

namespace regista {
namespace {

constexpr Duration kSourceIsSilent = std::chrono::seconds(1);  // it repeats itself many times a second

// A tick takes at most so many datagrams, so that requests and the status get their turn under a flood.
constexpr int kPacketsPerTick = 64;

}  // namespace

SslRefereeModule::SslRefereeModule(Bus& bus, const SslRefereeParams& params)
    : SocketModule("ssl-referee", bus),
      params_(params),
      socket_(UdpSocket::multicast_receiver(params.group, static_cast<std::uint16_t>(params.port), params.interface)) {
  bus.enroll(&reception_);
  expose<SslRefereeParams>(params_, [this](const SslRefereeParams& changed) { change(changed); });
}

SslRefereeModule::~SslRefereeModule() { bus().dismiss(&reception_); }

void SslRefereeModule::change(const SslRefereeParams& changed) {
  if (changed == params_) return;
  socket_ = UdpSocket::multicast_receiver(changed.group, static_cast<std::uint16_t>(changed.port), changed.interface);
  last_packet_.reset();
  params_ = changed;
}

std::string SslRefereeModule::note() const {
  const std::string source = params_.group + ":" + std::to_string(params_.port);
  if (!last_packet_) return "waiting for the referee at " + source;
  if (now() - *last_packet_ > kSourceIsSilent) return "the referee at " + source + " is silent";
  return last_command_;
}

void SslRefereeModule::on_tick(Time now) {
  for (int i = 0; i < kPacketsPerTick; ++i) {
    const auto bytes = socket_.receive();
    if (!bytes) break;
    take(*bytes, now);
  }
}

void SslRefereeModule::take(std::span<const std::uint8_t> bytes, Time now) {
  try {
    const GameState game = to_game_state(parse_packet<::Referee>(bytes));
    ++reception_.received;
    last_packet_ = now;
    last_command_ = command_text(game.command, game.team);
    bus().publish(channels::referee(), game);
  } catch (const MessageError& error) {
    ++reception_.refused;
    reception_.last_refusal =
        "packet of " + std::to_string(bytes.size()) + " bytes from the referee refused: " + error.what();
  }
}

}  // namespace regista
