#include "modules/bench/paper/published.h"

#include "modules/bench/paper/toml_file.h"

namespace regista::bench {
namespace {

PublishedRow row_of(const toml::node& node) {
  const toml::table* row = node.as_table();
  if (row == nullptr) throw std::runtime_error("a row must be a table");
  return {(*row)["where"].value_or(std::string()),
          required<std::string>(*row, "what"),
          required<std::string>(*row, "who"),
          required<double>(*row, "mean"),
          (*row)["sigma"].value<double>(),
          (*row)["min"].value<double>(),
          (*row)["max"].value<double>()};
}

}  // namespace

Published load_published(const std::string& file, const std::string& table) {
  return read_paper_file(file, [&](const toml::table& content) {
    Published published;
    published.samples = static_cast<std::size_t>(required<std::int64_t>(content, "samples"));
    for (const toml::node& row : required_list(content, table)) published.rows.push_back(row_of(row));
    const toml::table* units = content["units"].as_table();
    if (units == nullptr) throw std::runtime_error("'units' is missing");
    for (const auto& [what, unit] : *units) published.units[std::string(what.str())] = unit.value_or(std::string());
    for (const PublishedRow& row : published.rows) {
      if (!published.units.contains(row.what)) throw std::runtime_error("'units' does not name '" + row.what + "'");
    }
    return published;
  });
}

}  // namespace regista::bench
