#include "modules/convert/service.h"

#include "modules/convert/common.h"

namespace regista {

request_t MessageOf<Request>::to_message(const Request& request) {
  request_t message{};
  message.stamp_us = to_us(request.sent);
  message.id = request.id;
  message.module = request.module;
  message.verb = request.verb;
  message.key = request.key;
  message.value = request.value;
  return message;
}

Request MessageOf<Request>::from_message(const request_t& message) {
  return {time_from(message.stamp_us),         message.id,
          text_from(message.module, "module"), text_from(message.verb, "verb"),
          text_from(message.key, "key"),       text_from(message.value, "value")};
}

reply_t MessageOf<Reply>::to_message(const Reply& reply) {
  reply_t message{};
  message.stamp_us = to_us(reply.sent);
  message.id = reply.id;
  message.accepted = reply.accepted ? 1 : 0;
  message.module = reply.module;
  message.text = reply.text;
  return message;
}

Reply MessageOf<Reply>::from_message(const reply_t& message) {
  return {time_from(message.stamp_us), message.id, message.accepted != 0, text_from(message.module, "module"),
          text_from(message.text, "text")};
}

timing_t MessageOf<Timing>::to_message(const Timing& timing) {
  timing_t message{};
  message.stamp_us = to_us(timing.captured);
  message.robot_count = count_of(timing.robots);
  message.tick_ns = timing.tick_ns;
  message.module = timing.module;
  for (const RobotTime& robot : timing.robots) message.robots.push_back({number_code(robot.robot), robot.duration_ns});
  return message;
}

Timing MessageOf<Timing>::from_message(const timing_t& message) {
  Timing timing{time_from(message.stamp_us), text_from(message.module, "module"), message.tick_ns, {}};
  for (const robot_time_t& robot : message.robots)
    timing.robots.push_back({number_from(robot.robot), robot.duration_ns});
  return timing;
}

module_status_t MessageOf<ModuleStatus>::to_message(const ModuleStatus& status) {
  module_status_t message{};
  message.stamp_us = to_us(status.sent);
  message.pid = status.pid;
  message.uptime_us = status.uptime.count();
  message.rate_hz = status.rate_hz;
  message.tick_p50_ns = status.tick_p50_ns;
  message.tick_p99_ns = status.tick_p99_ns;
  message.received = status.received;
  message.skipped = status.skipped;
  message.refused = status.refused;
  message.parameters_fingerprint = status.parameters_fingerprint;
  message.module = status.module;
  message.host = status.host;
  message.note = status.note;
  return message;
}

ModuleStatus MessageOf<ModuleStatus>::from_message(const module_status_t& message) {
  ModuleStatus status;
  status.sent = time_from(message.stamp_us);
  status.module = text_from(message.module, "module");
  status.host = text_from(message.host, "host");
  status.pid = message.pid;
  status.uptime = Duration{message.uptime_us};
  status.rate_hz = at_least(message.rate_hz, 0.0, "rate_hz");
  status.tick_p50_ns = message.tick_p50_ns;
  status.tick_p99_ns = message.tick_p99_ns;
  status.received = message.received;
  status.skipped = message.skipped;
  status.refused = message.refused;
  status.parameters_fingerprint = message.parameters_fingerprint;
  status.note = text_from(message.note, "note");
  return status;
}

template std::vector<std::uint8_t> encode(const Request&);
template Request decode(std::span<const std::uint8_t>);
template std::vector<std::uint8_t> encode(const Reply&);
template Reply decode(std::span<const std::uint8_t>);
template std::vector<std::uint8_t> encode(const Timing&);
template Timing decode(std::span<const std::uint8_t>);
template std::vector<std::uint8_t> encode(const ModuleStatus&);
template ModuleStatus decode(std::span<const std::uint8_t>);

}  // namespace regista
