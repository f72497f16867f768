// Diagrams through gnuplot: data file and script, SVG and PNG of the same stem.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "modules/bench/summary.h"

namespace regista::bench {

/// gnuplot is missing or refused; what() is one line that says what to do. The data file and the script stay.
struct PlotError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Axis {
  std::string label;
  std::string unit = {};
  bool logarithmic = false;
  std::optional<double> low = {};  ///< ends of the axis; without: as the data ask
  std::optional<double> high = {};
};

struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
  std::optional<std::pair<double, double>> spread = {};  ///< low and high y of an error bar
};

struct Series {
  /// marks: large points of another shape each; points: many small dots; bars of several series: side by side, for x
  /// at whole numbers.
  enum class Style { line, line_points, points, marks, bars, dashes };
  std::string name;
  std::vector<PlotPoint> points;
  Style style = Style::line_points;
};

/// One box from p25 to p75 with the median, whiskers to min and max.
struct Box {
  std::string name;
  Summary summary;
};

struct Plot {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series = {};
  std::vector<Box> boxes = {};  ///< side by side at x = 1, 2, …, named below the axis; not together with series
};

/// Writes stem.dat, stem.gp, stem.svg and stem.png. Throws PlotError, also for a plot without a point.
void draw(const Plot& plot, const std::filesystem::path& stem);

}  // namespace regista::bench
