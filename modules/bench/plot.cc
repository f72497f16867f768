#include "modules/bench/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>

#include "modules/bench/tool.h"

namespace regista::bench {
namespace {

constexpr int kWidth_px = 1000;
constexpr int kHeight_px = 640;
constexpr int kNoSuchProgram = 127;  // of the shell

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += (c == '"' || c == '\\' ? std::string(1, '\\') : std::string()) + c;
  return out + "\"";
}

/// Blocks of x y low high, or of x min p25 p50 p75 max; gnuplot's "index" counts them.
std::string data_of(const Plot& plot) {
  std::string data;
  for (const Series& series : plot.series) {
    data += "# " + series.name + "\n";
    for (const PlotPoint& point : series.points) {
      const auto [low, high] = point.spread.value_or(std::pair{point.y, point.y});
      data += fmt::format("{} {} {} {}\n", point.x, point.y, low, high);
    }
    data += "\n\n";
  }
  for (std::size_t i = 0; i < plot.boxes.size(); ++i) {
    const Summary& s = plot.boxes[i].summary;
    data += fmt::format("# {}\n{} {} {} {} {} {}\n\n\n", plot.boxes[i].name, i + 1, s.min, s.p25, s.p50, s.p75, s.max);
  }
  return data;
}

std::string axis(const char* letter, const Axis& axis) {
  std::string script = fmt::format("set {}label {}\n", letter,
                                   quoted(axis.unit.empty() ? axis.label : axis.label + " [" + axis.unit + "]"));
  if (axis.logarithmic) script += fmt::format("set logscale {}\nset format {} '%g'\n", letter, letter);
  const auto end = [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : "*"; };
  if (axis.low || axis.high) script += fmt::format("set {}range [{}:{}]\n", letter, end(axis.low), end(axis.high));
  return script;
}

/// gnuplot's filled shapes first, then its hollow ones.
int shape(std::size_t place) {
  constexpr std::array kShapes{7, 5, 9, 11, 13, 6, 4, 8, 10, 12};
  constexpr std::size_t kShift = 3;  // when the colours begin again, the shapes are others
  return kShapes[(place + place / kShapes.size() * kShift) % kShapes.size()];
}

std::string colour(std::size_t place) {
  constexpr std::array kColours{"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd",
                                "#8c564b", "#17becf", "#e377c2", "#7f7f7f", "#bcbd22"};
  return std::string("rgb '") + kColours[place % kColours.size()] + "'";
}

/// How gnuplot draws a series; the colour goes by its place, so that bars and line match.
std::string style(Series::Style style, std::size_t place) {
  switch (style) {
    case Series::Style::line:
      return fmt::format("with lines lw 2 lc {}", colour(place));
    case Series::Style::points:
      return fmt::format("with points pt 7 ps 0.8 lc {}", colour(place));
    case Series::Style::marks:
      return fmt::format("with points pt {} ps 1.8 lc {}", shape(place), colour(place));
    case Series::Style::bars:
      return fmt::format("with boxes fs solid 0.4 lc {}", colour(place));
    case Series::Style::dashes:
      return fmt::format("with lines lw 1.5 dt 2 lc {}", colour(place));
    case Series::Style::line_points:
      break;
  }
  return fmt::format("with linespoints lw 2 pt {} ps 0.9 lc {}", shape(place), colour(place));
}

bool has_spread(const Series& series) {
  return std::any_of(series.points.begin(), series.points.end(), [](const PlotPoint& p) { return p.spread; });
}

std::size_t count_bars(std::span<const Series> series) {
  return static_cast<std::size_t>(
      std::count_if(series.begin(), series.end(), [](const Series& s) { return s.style == Series::Style::bars; }));
}

/// Series of bars share the place from one whole x to the next.
double bar_width(const Plot& plot) { return 0.8 / static_cast<double>(count_bars(plot.series)); }

/// gnuplot's expression for the x of a series: bars of several series stand side by side.
std::string x_of(const Plot& plot, std::size_t place) {
  const std::size_t bars = count_bars(plot.series);
  if (bars < 2 || plot.series[place].style != Series::Style::bars) return "1";
  const std::size_t before = count_bars(std::span(plot.series).first(place));
  const double middle = (static_cast<double>(bars) - 1.0) / 2.0;
  return fmt::format("($1+{})", (static_cast<double>(before) - middle) * bar_width(plot));
}

std::string curves(const Plot& plot, const std::string& data_file) {
  std::string script;
  const auto add = [&](const std::string& text) { script += (script.empty() ? "plot " : ", \\\n  ") + text; };
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (has_spread(series)) {
      add(fmt::format("{} index {} using 1:2:3:4 notitle with yerrorbars pt 0 lw 1 lc {}", data_file, i, colour(i)));
    }
    add(fmt::format("{} index {} using {}:2 title {} {}", data_file, i, x_of(plot, i), quoted(series.name),
                    style(series.style, i)));
  }
  for (std::size_t i = 0; i < plot.boxes.size(); ++i) {
    add(fmt::format("{} index {} using 1:3:2:6:5 notitle with candlesticks whiskerbars 0.5 fs solid 0.3 lw 1.5 lc {}",
                    data_file, i, colour(i)));
    add(fmt::format("{} index {} using 1:4:4:4:4 notitle with candlesticks lw 2 lc black", data_file, i));
  }
  return script + "\n";
}

std::string script_of(const Plot& plot, const std::string& stem) {
  const std::string look = fmt::format("size {},{} font 'DejaVu Sans,11' noenhanced", kWidth_px, kHeight_px);
  std::string script = "set encoding utf8\nset terminal svg " + look + " background 'white'\nset output " +
                       quoted(stem + ".svg") + "\nset title " + quoted(plot.title) + "\n" + axis("x", plot.x) +
                       axis("y", plot.y);
  script += "set grid xtics ytics mxtics mytics back lt 1 lw 0.8 lc rgb '#c8c8c8', lt 1 lw 0.5 lc rgb '#ececec'\n";
  script += "set border 3\nset tics nomirror\nset key outside top center horizontal\nset style fill solid 0.4\n";
  if (!plot.boxes.empty()) {
    script +=
        fmt::format("set boxwidth 0.4\nset xrange [0.4:{}]\nset xtics (", static_cast<double>(plot.boxes.size()) + 0.6);
    for (std::size_t i = 0; i < plot.boxes.size(); ++i) {
      script += fmt::format("{}{} {}", i > 0 ? ", " : "", quoted(plot.boxes[i].name), i + 1);
    }
    script += plot.boxes.size() > 5 ? ") rotate by -30\n" : ")\n";
  }
  if (count_bars(plot.series) > 1) script += fmt::format("set boxwidth {}\nset xtics 1\n", bar_width(plot));
  script += curves(plot, quoted(stem + ".dat"));
  script += "set terminal pngcairo " + look + "\nset output " + quoted(stem + ".png") + "\nreplot\n";
  return script;
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.flush();
  if (!out) throw PlotError("cannot write " + file.string() + ": no such folder, or the disk is full");
}

bool is_empty(const Plot& plot) {
  return plot.boxes.empty() && std::all_of(plot.series.begin(), plot.series.end(),
                                           [](const Series& series) { return series.points.empty(); });
}

}  // namespace

void draw(const Plot& plot, const std::filesystem::path& stem) {
  if (is_empty(plot)) throw PlotError(stem.string() + ": the plot has no point");
  Plot drawn = plot;
  std::erase_if(drawn.series, [](const Series& series) { return series.points.empty(); });
  const std::string name = stem.filename().string();
  write(stem.string() + ".dat", data_of(drawn));
  write(stem.string() + ".gp", script_of(drawn, name));
  const std::filesystem::path folder = stem.has_parent_path() ? stem.parent_path() : ".";
  const ToolResult result = run_tool(folder, {"gnuplot", name + ".gp"});
  if (result.status == kNoSuchProgram) {
    throw PlotError("no program gnuplot, so no " + stem.string() +
                    ".png: install it with 'apt-get install gnuplot-nox'");
  }
  if (result.status != 0) {
    std::string reason = result.output;
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw PlotError("gnuplot did not draw " + stem.string() + ".gp: " + reason);
  }
}

}  // namespace regista::bench
