#include "logs/module_channels.h"

#include <array>
#include <stdexcept>
#include <string_view>

namespace regista {
namespace {

struct ModuleOutputs {
  std::string_view module;
  bool per_team;
  std::array<std::string_view, 3> patterns;  ///< '@' stands for the team's letter; empty: none
};

// The task publishes for both teams, and stands in for the referee where a scenario states one.
constexpr std::array<ModuleOutputs, 9> kOutputs{{
    {"sim", false, {"VISION", "GEOMETRY", "TRUTH"}},
    {"ssl-vision", false, {"VISION", "GEOMETRY", ""}},
    {"ssl-referee", false, {"REFEREE", "", ""}},
    {"ssl-radio", false, {"", "", ""}},
    {"world-model", false, {"WORLD_STATE", "", ""}},
    {"task", false, {R"(TARGETS\.[YB])", "REFEREE", ""}},
    {"planner", true, {R"(PLAN\.@[0-9]+)", R"(GRAPH\.@)", ""}},
    {"controller", true, {R"(COMMANDS\.@)", "", ""}},
    {"viewer", false, {"", "", ""}},
}};

std::string with_team(std::string_view pattern, const std::string& team) {
  std::string text(pattern);
  if (const std::size_t at = text.find('@'); at != std::string::npos) text.replace(at, 1, team);
  return text;
}

const ModuleOutputs* find(std::string_view name) {
  for (const ModuleOutputs& entry : kOutputs) {
    if (entry.module == name) return &entry;
  }
  return nullptr;
}

std::invalid_argument unknown_module(const std::string& module) {
  std::string known;
  for (const ModuleOutputs& entry : kOutputs) {
    known += (known.empty() ? "" : ", ") + std::string(entry.module) + (entry.per_team ? "[.Y|.B]" : "");
  }
  return std::invalid_argument("no module '" + module + "', known: " + known);
}

}  // namespace

std::vector<std::string> outputs_of(const std::string& module) {
  const std::size_t dot = module.find('.');
  const ModuleOutputs* entry = find(std::string_view(module).substr(0, dot));
  const bool has_team = dot != std::string::npos;
  std::string team = has_team ? module.substr(dot + 1) : "[YB]";
  if (entry == nullptr || (has_team && (!entry->per_team || (team != "Y" && team != "B")))) {
    throw unknown_module(module);
  }
  std::vector<std::string> patterns;
  for (const std::string_view pattern : entry->patterns) {
    if (!pattern.empty()) patterns.push_back(with_team(pattern, team));
  }
  patterns.push_back(R"((?:TIMING|STATUS)\.)" + std::string(entry->module) + (entry->per_team ? R"(\.)" + team : ""));
  return patterns;
}

std::string all_but(const std::vector<std::string>& patterns) {
  if (patterns.empty()) return ".*";
  std::string alternatives;
  for (const std::string& pattern : patterns) alternatives += (alternatives.empty() ? "" : "|") + pattern;
  // LCM anchors the whole expression with ^ and $.
  return "(?!(?:" + alternatives + ")$).*";
}

}  // namespace regista
