// REQUEST, REPLY, TIMING and STATUS: request_t, reply_t, timing_t and module_status_t.
#pragma once

#include "modules/bus/service_values.h"
#include "modules/convert/message.h"
#include "regista/module_status_t.hpp"
#include "regista/reply_t.hpp"
#include "regista/request_t.hpp"
#include "regista/timing_t.hpp"

namespace regista {

template <>
struct MessageOf<Request> {
  using Message = request_t;
  static constexpr std::array<std::size_t, 0> kElementBytes{};
  static Message to_message(const Request& request);
  static Request from_message(const Message& message);
};

template <>
struct MessageOf<Reply> {
  using Message = reply_t;
  static constexpr std::array<std::size_t, 0> kElementBytes{};
  static Message to_message(const Reply& reply);
  static Reply from_message(const Message& message);
};

template <>
struct MessageOf<Timing> {
  using Message = timing_t;
  static constexpr std::array<std::size_t, 1> kElementBytes{10};
  static Message to_message(const Timing& timing);
  static Timing from_message(const Message& message);
};

template <>
struct MessageOf<ModuleStatus> {
  using Message = module_status_t;
  static constexpr std::array<std::size_t, 0> kElementBytes{};
  static Message to_message(const ModuleStatus& status);
  static ModuleStatus from_message(const Message& message);
};

}  // namespace regista
