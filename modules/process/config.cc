#include "modules/process/config.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace regista {
namespace {

constexpr std::array<std::string_view, 9> kSections{"scenario", "sim",    "world_model", "planner",  "controller",
                                                    "task",     "viewer", "ssl_vision",  "ssl_radio"};

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
    config.origin_ = path + ": ";
    try {
      flatten(toml::parse_file(path), "", config.entries_);
    } catch (const toml::parse_error& error) {
      const auto line = error.source().begin.line;
      const std::string place = line > 0 ? path + ":" + std::to_string(line) : path;
      throw ConfigError(place + ": " + std::string(error.description()));
    } catch (const ConfigError& error) {
      throw ConfigError(path + ": " + error.what());
    }
  }
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw ConfigError("--set " + setting + ": write --set section.key=value");
    config.entries_.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
  }
  config.check_sections();
  return config;
}

void Config::check_sections() const {
  for (const auto& [key, text] : entries_) {
    const std::string section = key.substr(0, key.find('.'));
    if (key.find('.') == std::string::npos ||
        std::find(kSections.begin(), kSections.end(), section) == kSections.end()) {
      std::string known;
      for (const std::string_view name : kSections) known += (known.empty() ? "" : ", ") + std::string(name);
      throw ConfigError(origin_ + "'" + key + "' belongs to no section, known sections: " + known);
    }
  }
}

std::vector<Config::Entry> Config::entries_of(const std::string& section) const {
  std::vector<Entry> found;
  for (const auto& [key, text] : entries_) {
    if (!key.starts_with(section + ".")) continue;
    const std::string rest = key.substr(section.size() + 1);
    if (rest.starts_with("yellow.") || rest.starts_with("blue.")) continue;
    found.emplace_back(rest, text);
  }
  return found;
}

Scenario Config::scenario() const {
  Scenario scenario;
  apply("scenario", scenario);
  try {
    validate(scenario);
  } catch (const std::invalid_argument& error) {
    throw ConfigError(origin_ + error.what());
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
