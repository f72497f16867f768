// How a module receives: a Listener decodes and counts, a Mailbox keeps the newest value, a Queue keeps them all.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <utility>

#include "modules/bus/bus.h"

namespace regista {

/// Calls back with every well-formed value; a malformed one is counted and remembered, never thrown.
template <class Value>
class Listener {
 public:
  Listener(Bus& bus, const Channel<Value>& channel, std::function<void(Value)> on_value)
      : bus_(bus), on_value_(std::move(on_value)) {
    subscription_ = bus.subscribe_raw(
        channel.name, [this](const std::string& name, std::span<const std::uint8_t> bytes) { receive(name, bytes); });
    bus_.enroll(&reception_);
  }
  ~Listener() { bus_.dismiss(&reception_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  const Reception& reception() const { return reception_; }
  void count_skipped() { ++reception_.skipped; }

 private:
  void receive(const std::string& name, std::span<const std::uint8_t> bytes) {
    std::optional<Value> value;
    try {
      value = decode<Value>(bytes);
    } catch (const MessageError& error) {
      ++reception_.refused;
      reception_.last_refusal = name + " refused: " + error.what();
      return;
    }
    ++reception_.received;
    on_value_(std::move(*value));
  }

  Bus& bus_;
  std::function<void(Value)> on_value_;
  Reception reception_;
  std::unique_ptr<Bus::Subscription> subscription_;
};

/// The newest value of a channel: newest wins, any may be lost or repeated.
template <class Value>
class Mailbox {
 public:
  Mailbox(Bus& bus, const Channel<Value>& channel)
      : bus_(bus), listener_(bus, channel, [this](Value value) { keep(std::move(value)); }) {}

  /// A value has come that take() has not handed out yet.
  bool fresh() const { return fresh_; }

  /// The newest value, or nullptr before the first; it is no longer fresh then.
  const Value* take() {
    fresh_ = false;
    return newest();
  }
  const Value* newest() const { return value_ ? &*value_ : nullptr; }

  /// When the newest value came in, on the bus's clock. Precondition: there is one.
  Time arrived() const { return arrived_; }

  /// True when there is a value that came in no longer ago than that.
  bool is_younger_than(Duration age) const { return value_ && bus_.now() - arrived_ <= age; }

  const Reception& reception() const { return listener_.reception(); }

 private:
  void keep(Value value) {
    if (fresh_) listener_.count_skipped();
    value_ = std::move(value);
    arrived_ = bus_.now();
    fresh_ = true;
  }

  Bus& bus_;
  std::optional<Value> value_;
  Time arrived_{};
  bool fresh_ = false;
  Listener<Value> listener_;
};

/// All values of a channel in order, for those that are no states: requests, frames of several cameras.
template <class Value>
class Queue {
 public:
  /// Beyond the capacity the oldest value is dropped and counted as skipped.
  Queue(Bus& bus, const Channel<Value>& channel, std::size_t capacity)
      : capacity_(capacity), listener_(bus, channel, [this](Value value) { keep(std::move(value)); }) {}

  bool empty() const { return values_.empty(); }

  std::optional<Value> pop() {
    if (values_.empty()) return std::nullopt;
    std::optional<Value> value = std::move(values_.front());
    values_.pop_front();
    return value;
  }

  const Reception& reception() const { return listener_.reception(); }

 private:
  void keep(Value value) {
    if (values_.size() == capacity_) {
      values_.pop_front();
      listener_.count_skipped();
    }
    values_.push_back(std::move(value));
  }

  std::size_t capacity_;
  std::deque<Value> values_;
  Listener<Value> listener_;
};

}  // namespace regista
