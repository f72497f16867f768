#include "modules/process/config.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace regista {
namespace {

struct Section {
  std::string_view name;
  bool per_team = false;  ///< may have the subsections .yellow and .blue
};
constexpr std::array kSections{
    Section{"scenario"},         Section{"sim"},        Section{"world_model"}, Section{"planner", true},
    Section{"controller", true}, Section{"ssl_vision"}, Section{"ssl_referee"}, Section{"ssl_radio"}};

bool names_a_team(std::string_view rest) { return rest.starts_with("yellow.") || rest.starts_with("blue."); }

std::string known_sections() {
  std::string known;
  for (const Section& section : kSections) known += (known.empty() ? "" : ", ") + std::string(section.name);
  return known;
}

std::string text_of(const toml::node& node, const std::string& key) {
  if (const auto* value = node.as_string()) return value->get();
  if (const auto* value = node.as_integer()) return std::to_string(value->get());
  if (const auto* value = node.as_floating_point()) return params_detail::print(value->get());
  if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
  throw ConfigError(key + " must be a string, a number or true/false");
}

void flatten(const toml::table& table, const std::string& prefix,
             std::vector<std::pair<std::string, std::string>>& out) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix + std::string(name.str());
    if (const toml::table* inner = node.as_table()) {
      flatten(*inner, key + ".", out);
    } else {
      out.emplace_back(key, text_of(node, key));
    }
  }
}

std::filesystem::path scenario_folder() {
  // Beside bin/, so that a build can be moved or installed as a whole.
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "scenarios";
}

}  // namespace

Config Config::load(const std::string& path, const std::vector<std::string>& settings) {
  Config config;
  if (!path.empty()) {
    config.file_ = path;
    std::vector<std::pair<std::string, std::string>> entries;
    try {
      flatten(toml::parse_file(path), "", entries);
    } catch (const toml::parse_error& error) {
      const auto line = error.source().begin.line;
      const std::string place = line > 0 ? path + ":" + std::to_string(line) : path;
      throw ConfigError(place + ": " + std::string(error.description()));
    } catch (const ConfigError& error) {
      throw ConfigError(path + ": " + error.what());
    }
    for (const auto& [key, text] : entries) config.entries_.push_back({key, text, path + ": "});
  }
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw ConfigError("--set " + setting + ": write --set section.key=value");
    config.entries_.push_back({setting.substr(0, equals), setting.substr(equals + 1), "--set " + setting + ": "});
  }
  config.check_sections();
  return config;
}

void Config::check_sections() const {
  for (const Entry& entry : entries_) {
    const std::size_t dot = entry.key.find('.');
    const std::string name = entry.key.substr(0, dot);
    const auto* const section =
        std::find_if(kSections.begin(), kSections.end(), [&](const Section& known) { return known.name == name; });
    if (dot == std::string::npos || section == kSections.end()) {
      throw ConfigError(entry.origin + "'" + entry.key +
                        "' belongs to no section, known sections: " + known_sections());
    }
    if (!section->per_team && names_a_team(std::string_view(entry.key).substr(dot + 1))) {
      throw ConfigError(entry.origin + "section '" + name + "' is not per team");
    }
  }
}

std::vector<Config::Entry> Config::entries_of(const std::string& section) const {
  std::vector<Entry> found;
  for (const Entry& entry : entries_) {
    if (!entry.key.starts_with(section + ".")) continue;
    const std::string rest = entry.key.substr(section.size() + 1);
    if (!names_a_team(rest)) found.push_back({rest, entry.text, entry.origin});
  }
  return found;
}

Scenario Config::scenario() const {
  Scenario scenario;
  apply("scenario", scenario);
  try {
    validate(scenario);
  } catch (const std::invalid_argument& error) {
    throw ConfigError((file_.empty() ? "" : file_ + ": ") + error.what());
  }
  return scenario;
}

std::vector<std::string> shipped_scenarios() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(scenario_folder(), none)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string scenario_file(const std::string& name_or_path) {
  if (std::filesystem::is_regular_file(name_or_path)) return name_or_path;
  const std::filesystem::path shipped = scenario_folder() / (name_or_path + ".toml");
  if (std::filesystem::is_regular_file(shipped)) return shipped.string();
  std::string known;
  for (const std::string& name : shipped_scenarios()) known += (known.empty() ? "" : ", ") + name;
  throw ConfigError("no scenario '" + name_or_path + "': give a .toml file or one of: " + known);
}

}  // namespace regista
