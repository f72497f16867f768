// Measured samples beside the rows a paper prints: as a table, and as box plots.
#pragma once

#include "modules/bench/paper/published.h"
#include "modules/bench/plot.h"
#include "modules/bench/table.h"

namespace regista::bench {

/// One quantity of one planner in one scenario; the names are those of the published rows.
struct Sampled {
  std::string where, what, who;
  std::vector<double> values;
  std::size_t failures = 0;  ///< tries that gave no value
};

/// Per scenario and quantity: each published row, the measured one of the same planner below it, then the planners that
/// the paper does not have.
Table comparison(const std::string& title, const Published& published, const std::vector<Sampled>& sampled);

/// Boxes of one quantity in one scenario. A published row is a box of no height at its mean with whiskers from its
/// minimum to its maximum: more is not printed.
Plot boxes(const std::string& title, const std::string& where, const std::string& what, const Published& published,
           const std::vector<Sampled>& sampled);

}  // namespace regista::bench
