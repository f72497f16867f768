// Asks running modules: a request is repeated until its reply, because any message may be lost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modules/bus/bus.h"

namespace regista {

/// A request with a fresh id.
Request make_request(Time sent, const std::string& module, const std::string& verb, const std::string& key = {},
                     const std::string& value = {});

/// Longer than the slowest module's tick and a start-up of its bus.
inline constexpr Duration kAnswerTimeout = std::chrono::seconds(2);

/// One reply per request, in their order; nullopt where none came in time. Repeats unanswered requests every 100 ms.
/// Throws BusError when the bus breaks.
std::vector<std::optional<Reply>> ask(Bus& bus, const std::vector<Request>& requests,
                                      Duration timeout = kAnswerTimeout);

/// What to do when the module did not answer, one line.
std::string no_answer(const std::string& module, const std::string& lcm_url);

/// Asks one module and prints its text; returns 0. Throws CommandError when it refuses or
/// does not answer.
int ask_and_print(const std::string& lcm_url, const std::string& module, const std::string& verb,
                  const std::string& key = {}, const std::string& value = {});

}  // namespace regista
