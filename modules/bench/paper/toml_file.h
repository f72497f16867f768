// What the readers of modules/bench/data/paper/ share; for .cc files alone.
#pragma once

#include <toml++/toml.h>

#include <stdexcept>
#include <string>

#include "modules/bench/grid.h"
#include "world_model/types/geometry.h"

namespace regista::bench {

/// Calls read(table) with the file's content; whatever it throws names the file then.
template <class Read>
auto read_paper_file(const std::string& name, Read&& read) {
  const std::string file = data_file("paper/" + name).string();
  try {
    return read(toml::parse_file(file));
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(file + ": " + std::string(error.description()));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

/// Throws std::runtime_error where there is no such value.
template <class Value>
Value required(const toml::table& table, const std::string& key) {
  const auto value = table[key].template value<Value>();
  if (!value) throw std::runtime_error("'" + key + "' is missing or of another type");
  return *value;
}

/// An array of two numbers.
inline Vec2 point_of(const toml::node* node, const std::string& key) {
  const toml::array* pair = node == nullptr ? nullptr : node->as_array();
  if (pair == nullptr || pair->size() != 2) throw std::runtime_error("'" + key + "' must be [x, y]");
  const auto x = (*pair)[0].value<double>();
  const auto y = (*pair)[1].value<double>();
  if (!x || !y) throw std::runtime_error("'" + key + "' must be two numbers");
  return {*x, *y};
}

inline const toml::array& required_list(const toml::table& table, const std::string& key) {
  const toml::array* list = table[key].as_array();
  if (list == nullptr) throw std::runtime_error("'" + key + "' is missing or no list");
  return *list;
}

}  // namespace regista::bench
