#include "modules/ssl/ssl_vision_module.h"

#include "modules/convert/common.h"
#include "modules/convert/vision.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_geometry_convert.h"
#include "modules/ssl/ssl_vision_convert.h"
#include "ssl_vision_wrapper.pb.h"

namespace regista {
namespace {

constexpr Duration kAnnounceEvery = std::chrono::seconds(1);
constexpr Duration kSourceIsSilent = std::chrono::seconds(1);  // 60 frames of the slowest camera

// A tick takes at most so many datagrams, so that requests and the status get their turn under a flood.
constexpr int kPacketsPerTick = 64;

}  // namespace

SslVisionModule::SslVisionModule(Bus& bus, const SslVisionParams& params)
    : SocketModule("ssl-vision", bus),
      params_(params),
      socket_(UdpSocket::multicast_receiver(params.group, static_cast<std::uint16_t>(params.port), params.interface)) {
  bus.enroll(&reception_);
  expose<SslVisionParams>(params_, [this](const SslVisionParams& changed) { change(changed); });
}

SslVisionModule::~SslVisionModule() { bus().dismiss(&reception_); }

void SslVisionModule::change(const SslVisionParams& changed) {
  if (changed.group != params_.group || changed.port != params_.port || changed.interface != params_.interface) {
    socket_ = UdpSocket::multicast_receiver(changed.group, static_cast<std::uint16_t>(changed.port), changed.interface);
    last_packet_.reset();
  }
  params_ = changed;
  if (!field_) return;
  field_->yellow_on_positive_x = params_.yellow_on_positive_x;
  announce(*field_, now());
}

std::optional<Time> SslVisionModule::due() const {
  if (!field_) return std::nullopt;
  return announced_ + kAnnounceEvery;
}

std::string SslVisionModule::note() const {
  const std::string source = params_.group + ":" + std::to_string(params_.port);
  if (!last_packet_) return "waiting for SSL-Vision at " + source;
  if (now() - *last_packet_ > kSourceIsSilent) return "SSL-Vision at " + source + " is silent";
  if (!field_) return "no geometry yet from " + source;
  if (skipped_in_last_frame_ > 0) {
    return std::to_string(skipped_in_last_frame_) + " robots seen without number or heading";
  }
  return {};
}

void SslVisionModule::on_tick(Time now) {
  for (int i = 0; i < kPacketsPerTick; ++i) {
    const auto bytes = socket_.receive();
    if (!bytes) break;
    take(*bytes, now);
  }
  if (field_ && now - announced_ >= kAnnounceEvery) announce(*field_, now);
}

void SslVisionModule::take(std::span<const std::uint8_t> bytes, Time now) {
  try {
    hand_on(parse_packet<SSL_WrapperPacket>(bytes), now);
    ++reception_.received;
    last_packet_ = now;
  } catch (const MessageError& error) {
    ++reception_.refused;
    reception_.last_refusal =
        "packet of " + std::to_string(bytes.size()) + " bytes from SSL-Vision refused: " + error.what();
  }
}

void SslVisionModule::hand_on(const SSL_WrapperPacket& packet, Time now) {
  require(packet.has_detection() || packet.has_geometry(), "neither detection nor geometry in it");
  // Both are converted before either is published: a packet is taken whole or not at all.
  std::optional<FieldGeometry> field;
  std::optional<ConvertedFrame> converted;
  if (packet.has_geometry()) field = to_field_geometry(packet.geometry(), params_.yellow_on_positive_x);
  if (packet.has_detection()) converted = to_vision_frame(packet.detection());
  if (field && field != field_) announce(*field, now);
  if (!converted) return;
  skipped_in_last_frame_ = converted->robots_skipped;
  robots_skipped_ += converted->robots_skipped;
  bus().publish(channels::vision(), converted->frame);
}

void SslVisionModule::announce(const FieldGeometry& field, Time now) {
  field_ = field;
  announced_ = now;
  bus().publish(channels::geometry(), FieldAnnouncement{now, field});
}

}  // namespace regista
