#include "modules/bench/paper/sampling_findings.h"

#include <fmt/core.h>

#include <stdexcept>

namespace regista::bench {
namespace {

std::string place_of(const std::string& planner, double at) {
  return at > 0.0 ? fmt::format("{} at {:g}", planner, at) : planner;
}

}  // namespace

Table findings_table(const std::string& title, const std::vector<DataTable>& rows, const Measurement& measured) {
  Table table{title,
              {{"the paper says"}, {"quantity"}, {"of"}, {"value"}, {"shall be"}, {"than"}, {"value"}, {"holds"}}};
  for (const DataTable& row : rows) {
    const std::string quantity = row.text("quantity");
    const std::string relation = row.text("relation");
    if (relation != ">" && relation != "<") throw std::runtime_error("relation must be > or <, not " + relation);
    const double at = row.number_or("at", 0.0);
    const std::optional<double> left = measured(quantity, row.text("of"), at);
    std::optional<double> right;
    std::string other = "(number of the paper)";
    if (row.has("value")) {
      right = row.number("value");
    } else {
      other = place_of(row.text("than"), row.number_or("than_at", at));
      right = measured(quantity, row.text("than"), row.number_or("than_at", at));
    }
    const auto cell = [](const std::optional<double>& value) { return value ? Cell{*value} : Cell{}; };
    Cell holds;
    if (left && right) holds = std::string((relation == ">" ? *left > *right : *left < *right) ? "yes" : "no");
    table.add(
        {row.text("text"), quantity, place_of(row.text("of"), at), cell(left), relation, other, cell(right), holds});
  }
  table.notes = {"the figure is lost; each sentence of the text about it is held against the numbers of this run,",
                 "their means alone: how certain a difference is, the table before says"};
  return table;
}

}  // namespace regista::bench
