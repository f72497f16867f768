// What every module is: a deterministic function of the messages it got and the clock it was handed. The same class
// runs in a process of its own, in lock step with the others, and over a recorded log.
//
// Laws: tick() reads mailboxes and publishes; it never blocks, sleeps or reads a clock. A module is ticked when ready()
// or when now >= due(), and after tick(now) its due() lies after now. Requests are served before the work.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "modules/bus/mailbox.h"
#include "world_model/params.h"

namespace regista {

/// Thrown by a verb: the reply says no, with this text.
struct RequestRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Module {
 public:
  /// name is the one in STATUS and REQUEST: "sim", "planner.Y".
  Module(std::string name, Bus& bus);
  virtual ~Module() = default;
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  const std::string& name() const { return name_; }

  /// Something has come in that wants a tick.
  bool ready() const { return !requests_.empty() || has_input(); }

  /// When to tick although nothing comes in; nullopt: never.
  virtual std::optional<Time> due() const { return std::nullopt; }

  void tick(Time now);

  /// One line for people, for STATUS: what it waits for. Empty when all is well.
  virtual std::string note() const { return {}; }

  /// Of the names and values of all parameters now in force.
  std::int64_t parameters_fingerprint() const;

 protected:
  virtual bool has_input() const = 0;
  virtual void on_tick(Time now) = 0;

  Bus& bus() { return bus_; }
  const Bus& bus() const { return bus_; }

  /// A verb this module answers: takes the request, returns the reply's text or throws RequestRefused.
  void answer(const std::string& verb, std::function<std::string(const Request&)> action);

  /// Opens a parameter struct to param.list, param.get and param.set; `apply` gets the new set, validated whole.
  template <class P>
  void expose(const P& params, std::function<void(const P&)> apply) {
    list_parameters_ = [&params] { return list_params(params); };
    set_parameter_ = [&params, apply](const std::string& key, const std::string& text) {
      P changed = params;
      set_param(changed, key, text);
      apply(changed);
    };
  }

 private:
  void serve(const Request& request, Time now);
  std::string act_on(const Request& request);
  std::string list_text() const;

  std::string name_;
  Bus& bus_;
  Queue<Request> requests_;
  std::map<std::string, std::function<std::string(const Request&)>> verbs_;
  std::function<std::vector<ParamInfo>()> list_parameters_;
  std::function<void(const std::string&, const std::string&)> set_parameter_;
  std::deque<Reply> replies_;  ///< the last ones, so that a repeated request is answered but not repeated
};

}  // namespace regista
