// The bus a module is handed: typed publishing, raw subscriptions, one message at a time. Owns the lcm::LCM; a
// transport is a URL (udpm:// between processes, memq:// within one, file:// to read a log).
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "modules/bus/channels.h"
#include "modules/convert/codec.h"

namespace regista {

/// The injected clock: simulated in lock step, the machine's in a process.
using Clock = std::function<Time()>;

/// The transport could not be opened or broke; what() is one line that says what to do.
struct BusError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a subscription took in since it was made.
struct Reception {
  std::int64_t received = 0;  ///< well-formed messages
  std::int64_t skipped = 0;   ///< replaced by newer ones, or dropped from a full queue, before they were read
  std::int64_t refused = 0;   ///< malformed messages
  std::string last_refusal;   ///< channel and reason, empty where none
};

class Bus {
 public:
  using RawHandler = std::function<void(const std::string& channel, std::span<const std::uint8_t> bytes)>;

  /// Throws BusError when the transport does not open.
  Bus(const std::string& url, Clock clock);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  Time now() const { return clock_(); }

  /// Readable when handle() has something to do: for waiting on the bus and on other things at once.
  int file_descriptor() const;

  /// Throws BusError when the transport refuses, MessageError when the value cannot be encoded.
  template <class Value>
  void publish(const Channel<Value>& channel, const Value& value) {
    publish_raw(channel.name, encode(value));
  }
  void publish_raw(const std::string& channel, std::span<const std::uint8_t> bytes);

  /// Calls the handler with every message whose channel matches the regular expression, until the returned handle dies;
  /// the handle must die before the bus. A handler may throw: handle() rethrows after LCM has returned.
  class Subscription;
  std::unique_ptr<Subscription> subscribe_raw(const std::string& channel_pattern, RawHandler handler);

  /// Waits at most that long for a message and hands out one. False when none came or a log has ended.
  /// Rethrows what a handler threw. Throws BusError when the transport broke.
  bool handle(Duration timeout);

  /// All subscriptions' counts together.
  Reception reception() const;
  void enroll(const Reception* reception);
  void dismiss(const Reception* reception);

 private:
  std::string url_;
  Clock clock_;
  std::unique_ptr<lcm::LCM> lcm_;
  std::exception_ptr thrown_;
  std::vector<const Reception*> receptions_;
};

/// Keeps a raw subscription alive.
class Bus::Subscription {
 public:
  Subscription(Bus& bus, const std::string& channel_pattern, RawHandler handler);
  ~Subscription();
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

 private:
  void on_message(const lcm::ReceiveBuffer* buffer, const std::string& channel);
  Bus& bus_;
  RawHandler handler_;
  lcm::Subscription* subscription_;
};

}  // namespace regista
