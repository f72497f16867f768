#include "modules/bench/grid.h"

#include <toml++/toml.h>

#include <stdexcept>

namespace regista::bench {
namespace {

using Values = std::vector<std::string>;

std::string text_of(const toml::node& node, const std::string& key) {
  if (const auto* value = node.as_integer()) return std::to_string(value->get());
  if (const auto* value = node.as_floating_point()) return params_detail::print(value->get());
  if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
  throw std::runtime_error(key + " must be a list of numbers or true/false");
}

Values values_of(const toml::node* node, const std::string& key) {
  const toml::array* list = node == nullptr ? nullptr : node->as_array();
  if (list == nullptr || list->empty()) throw std::runtime_error(key + " must be a list with a value at least");
  Values values;
  for (const toml::node& value : *list) values.push_back(text_of(value, key));
  return values;
}

/// Every setting with every value.
std::vector<Setting> combined(const std::vector<Setting>& settings, const std::string& key, const Values& values) {
  std::vector<Setting> out;
  for (const Setting& setting : settings) {
    for (const std::string& value : values) {
      out.push_back(setting);
      out.back().params.emplace_back(key, value);
    }
  }
  return out;
}

std::vector<Setting> settings_of(const std::string& planner, const toml::table& table, const Values& simplify,
                                 const Values& times_us) {
  std::vector<Setting> settings{Setting{planner, 0.0, {}}};
  for (const auto& [key, node] : table) {
    settings = combined(settings, std::string(key.str()), values_of(&node, planner + "." + std::string(key.str())));
  }
  settings = combined(settings, "simplify", simplify);
  std::vector<Setting> out;
  for (const Setting& setting : settings) {
    for (const std::string& time_us : times_us) {
      out.push_back(setting);
      out.back().time_us = std::stod(time_us);
    }
  }
  return out;
}

}  // namespace

std::string Setting::text() const {
  std::string out;
  for (const auto& [key, value] : params) out += (out.empty() ? "" : ", ") + key + " " + value;
  return out;
}

PlanningParams Setting::planning_params() const {
  PlanningParams out;
  for (const auto& [key, value] : params) set_param(out, "ompl." + key, value);
  return out;
}

std::vector<Setting> load_grid(const std::filesystem::path& file) {
  try {
    const toml::table grid = toml::parse_file(file.string());
    const Values times_us = values_of(grid.get("time_us"), "time_us");
    const Values simplify = values_of(grid.get("simplify"), "simplify");
    std::vector<Setting> settings;
    for (const auto& [name, node] : grid) {
      if (name == "time_us" || name == "simplify") continue;
      const toml::table* table = node.as_table();
      if (table == nullptr) throw std::runtime_error(std::string(name.str()) + " must be the table of a planner");
      const std::vector<Setting> more = settings_of(std::string(name.str()), *table, simplify, times_us);
      settings.insert(settings.end(), more.begin(), more.end());
    }
    for (const Setting& setting : settings) setting.planning_params();
    return settings;
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(file.string() + ": " + std::string(error.description()));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

std::filesystem::path data_file(const std::string& name) {
  // Beside bin/, as the scenarios are.
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "bench_data" / name;
}

}  // namespace regista::bench
