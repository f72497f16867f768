#include "modules/bus/module.h"

#include <algorithm>

namespace regista {
namespace {

constexpr std::size_t kRequestsWaiting = 64;     // a person types them
constexpr std::size_t kRepliesRemembered = 256;  // longer than anyone repeats a request

}  // namespace

Module::Module(std::string name, Bus& bus)
    : name_(std::move(name)), bus_(bus), requests_(bus, channels::request(), kRequestsWaiting) {
  answer("param.list", [this](const Request&) { return list_text(); });
  answer("param.get", [this](const Request& request) {
    for (const ParamInfo& info : list_parameters_ ? list_parameters_() : std::vector<ParamInfo>{}) {
      if (info.key == request.key) return info.value;
    }
    throw RequestRefused("no parameter '" + request.key + "', see: regista param list " + name_);
  });
  answer("param.set", [this](const Request& request) {
    if (!set_parameter_) throw RequestRefused(name_ + " has no parameters");
    set_parameter_(request.key, request.value);
    return request.key + " = " + request.value;
  });
}

void Module::tick(Time now) {
  while (const std::optional<Request> request = requests_.pop()) {
    if (request->module == name_) serve(*request, now);
  }
  on_tick(now);
}

void Module::answer(const std::string& verb, std::function<std::string(const Request&)> action) {
  verbs_[verb] = std::move(action);
}

void Module::serve(const Request& request, Time now) {
  const auto known =
      std::find_if(replies_.begin(), replies_.end(), [&](const Reply& reply) { return reply.id == request.id; });
  if (known != replies_.end()) {
    bus_.publish(channels::reply(), *known);
    return;
  }
  Reply reply{now, request.id, true, name_, {}};
  try {
    reply.text = act_on(request);
  } catch (const std::exception& error) {
    reply.accepted = false;
    reply.text = error.what();
  }
  replies_.push_back(reply);
  if (replies_.size() > kRepliesRemembered) replies_.pop_front();
  bus_.publish(channels::reply(), reply);
}

std::string Module::act_on(const Request& request) {
  const auto verb = verbs_.find(request.verb);
  if (verb != verbs_.end()) return verb->second(request);
  std::string known;
  for (const auto& [name, action] : verbs_) known += (known.empty() ? "" : ", ") + name;
  throw RequestRefused(name_ + " does not know '" + request.verb + "', it knows: " + known);
}

std::string Module::list_text() const {
  std::string text;
  for (const ParamInfo& info : list_parameters_ ? list_parameters_() : std::vector<ParamInfo>{}) {
    text += info.key + " = " + info.value + (info.unit.empty() ? "" : " " + info.unit) + "  # " + info.help + "\n";
  }
  return text;
}

std::int64_t Module::parameters_fingerprint() const {
  // FNV-1a, 64 bit: any change of a name or value changes it, and it is the same on every machine.
  std::uint64_t hash = 14695981039346656037ULL;
  for (const ParamInfo& info : list_parameters_ ? list_parameters_() : std::vector<ParamInfo>{}) {
    for (const char c : info.key + "=" + info.value + "\n") {
      hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211ULL;
    }
  }
  return static_cast<std::int64_t>(hash);
}

}  // namespace regista
