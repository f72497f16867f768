#include "modules/regista/service_client.h"

#include <fmt/core.h>

#include <algorithm>
#include <random>

#include "modules/bus/mailbox.h"
#include "modules/convert/service.h"
#include "modules/process/real_clock.h"
#include "modules/regista/command.h"

namespace regista {
namespace {

constexpr Duration kRepeatEvery = std::chrono::milliseconds(100);  // a lost request costs a person nothing noticeable

std::int64_t fresh_id() {
  std::random_device device;
  return static_cast<std::int64_t>((std::uint64_t{device()} << 32 | device()) >> 1);
}

void keep(const Reply& reply, const std::vector<Request>& requests, std::vector<std::optional<Reply>>& replies) {
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (requests[i].id == reply.id && requests[i].module == reply.module) replies[i] = reply;
  }
}

bool complete(const std::vector<std::optional<Reply>>& replies) {
  return std::all_of(replies.begin(), replies.end(), [](const auto& reply) { return reply.has_value(); });
}

}  // namespace

Request make_request(Time sent, const std::string& module, const std::string& verb, const std::string& key,
                     const std::string& value) {
  return {sent, fresh_id(), module, verb, key, value};
}

std::vector<std::optional<Reply>> ask(Bus& bus, const std::vector<Request>& requests, Duration timeout) {
  std::vector<std::optional<Reply>> replies(requests.size());
  const Listener<Reply> listener(bus, channels::reply(), [&](const Reply& reply) { keep(reply, requests, replies); });
  const Time end = bus.now() + timeout;
  while (!complete(replies) && bus.now() < end) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
      if (!replies[i]) bus.publish(channels::request(), requests[i]);
    }
    const Time repeat = std::min(end, bus.now() + kRepeatEvery);
    while (!complete(replies) && bus.now() < repeat) bus.handle(repeat - bus.now());
  }
  return replies;
}

std::string no_answer(const std::string& module, const std::string& lcm_url) {
  const std::size_t dot = module.find('.');
  const std::string program = "regista-" + module.substr(0, dot);
  const std::string team = dot == std::string::npos ? "" : " --team " + module.substr(dot + 1);
  return fmt::format("no answer from {} on {}: start it with 'regista up' or '{}{}'", module, lcm_url, program, team);
}

int ask_and_print(const std::string& lcm_url, const std::string& module, const std::string& verb,
                  const std::string& key, const std::string& value) {
  Bus bus(lcm_url, real_clock());
  const auto reply = ask(bus, {make_request(bus.now(), module, verb, key, value)}).front();
  if (!reply) throw CommandError(no_answer(module, lcm_url));
  if (!reply->accepted) throw CommandError(module + ": " + reply->text);
  fmt::print("{}{}", reply->text, reply->text.ends_with('\n') ? "" : "\n");
  return 0;
}

}  // namespace regista
