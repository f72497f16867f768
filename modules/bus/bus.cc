#include "modules/bus/bus.h"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace regista {
namespace {

// LCM's default of 30 waiting messages per subscription is less than one tick of a team's plans; a queue that is full
// drops the newest message, which is the one that is wanted.
constexpr int kQueueCapacity = 1024;

std::string cannot_open(const std::string& url) {
  std::string text = "cannot open the LCM bus '" + url + "'";
  if (url.starts_with("udpm")) {
    text +=
        "; if LCM names the multicast route above, run as root: ip link set lo multicast on; "
        "ip route add 224.0.0.0/4 dev lo";
  }
  return text;
}

}  // namespace

Bus::Bus(const std::string& url, Clock clock)
    : url_(url), clock_(std::move(clock)), lcm_(std::make_unique<lcm::LCM>(url)) {
  if (!lcm_->good()) throw BusError(cannot_open(url));
}

Bus::~Bus() = default;

int Bus::file_descriptor() const { return lcm_->getFileno(); }

void Bus::publish_raw(const std::string& channel, std::span<const std::uint8_t> bytes) {
  if (lcm_->publish(channel, bytes.data(), static_cast<unsigned int>(bytes.size())) != 0) {
    throw BusError("publishing " + std::to_string(bytes.size()) + " bytes on " + channel + " to '" + url_ + "' failed");
  }
}

std::unique_ptr<Bus::Subscription> Bus::subscribe_raw(const std::string& channel_pattern, RawHandler handler) {
  return std::make_unique<Subscription>(*this, channel_pattern, std::move(handler));
}

bool Bus::handle(Duration timeout) {
  // Rounded up: waking early would spin until the moment asked for.
  const auto timeout_ms = std::chrono::ceil<std::chrono::milliseconds>(std::max(timeout, Duration::zero())).count();
  errno = 0;
  const int handled = lcm_->handleTimeout(static_cast<int>(timeout_ms));
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  if (handled < 0 && errno == EINTR) return false;  // a signal ended the wait
  if (handled < 0 && !url_.starts_with("file")) throw BusError("the LCM bus '" + url_ + "' broke while receiving");
  return handled > 0;
}

Reception Bus::reception() const {
  Reception sum;
  for (const Reception* one : receptions_) {
    sum.received += one->received;
    sum.skipped += one->skipped;
    sum.refused += one->refused;
    if (!one->last_refusal.empty()) sum.last_refusal = one->last_refusal;
  }
  return sum;
}

void Bus::enroll(const Reception* reception) { receptions_.push_back(reception); }
void Bus::dismiss(const Reception* reception) { std::erase(receptions_, reception); }

Bus::Subscription::Subscription(Bus& bus, const std::string& channel_pattern, RawHandler handler)
    : bus_(bus), handler_(std::move(handler)) {
  subscription_ = bus_.lcm_->subscribe(channel_pattern, &Subscription::on_message, this);
  if (subscription_ == nullptr) throw BusError("cannot subscribe to '" + channel_pattern + "'");
  subscription_->setQueueCapacity(kQueueCapacity);
}

Bus::Subscription::~Subscription() { bus_.lcm_->unsubscribe(subscription_); }

void Bus::Subscription::on_message(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
  try {
    handler_(channel, {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size});
  } catch (...) {
    // An exception must not cross LCM's C code; the first one is rethrown by Bus::handle.
    if (!bus_.thrown_) bus_.thrown_ = std::current_exception();
  }
}

}  // namespace regista
