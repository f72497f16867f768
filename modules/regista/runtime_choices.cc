#include "modules/regista/runtime_choices.h"

#include <algorithm>

namespace regista {
namespace {

constexpr std::size_t kMostAsked = 64;     // waiting for their replies; a person types them
constexpr std::size_t kMostChoices = 256;  // of one module; more than any has parameters

/// "planner.Y" is configured by planner.yellow, "world-model" by world_model.
std::string section_of(const std::string& module) {
  const std::size_t dot = module.find('.');
  std::string section = module.substr(0, dot);
  std::replace(section.begin(), section.end(), '-', '_');
  if (dot == std::string::npos) return section;
  return section + (module.substr(dot + 1) == "B" ? ".blue" : ".yellow");
}

}  // namespace

RuntimeChoices::RuntimeChoices(const std::vector<std::string>& modules) {
  for (const std::string& module : modules) choices_[module];
}

void RuntimeChoices::take(const Request& request) {
  if (request.verb != "planner.use" && request.verb != "param.set") return;
  if (choices_.count(request.module) == 0) return;
  const auto repeated = std::find_if(asked_.begin(), asked_.end(), [&](const Request& asked) {
    return asked.id == request.id && asked.module == request.module;
  });
  if (repeated != asked_.end()) return;
  asked_.push_back(request);
  if (asked_.size() > kMostAsked) asked_.pop_front();
}

void RuntimeChoices::take(const Reply& reply) {
  const auto asked = std::find_if(asked_.begin(), asked_.end(), [&](const Request& request) {
    return request.id == reply.id && request.module == reply.module;
  });
  if (asked == asked_.end()) return;
  const Choice choice = asked->verb == "planner.use" ? Choice{"use", asked->key} : Choice{asked->key, asked->value};
  asked_.erase(asked);
  if (!reply.accepted) return;
  std::vector<Choice>& choices = choices_[reply.module];
  std::erase_if(choices, [&](const Choice& older) { return older.key == choice.key; });
  choices.push_back(choice);
  if (choices.size() > kMostChoices) choices.erase(choices.begin());
}

std::vector<std::string> RuntimeChoices::settings_of(const std::string& module) const {
  std::vector<std::string> settings;
  const auto found = choices_.find(module);
  if (found == choices_.end()) return settings;
  for (const Choice& choice : found->second) {
    settings.push_back(section_of(module) + "." + choice.key + "=" + choice.value);
  }
  return settings;
}

}  // namespace regista
