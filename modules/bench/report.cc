#include "modules/bench/report.h"

#include <cstdio>
#include <iostream>

namespace regista::bench {

Report::Report(const Run& run) : out_(run.out), record_(record_of(run)) { std::filesystem::create_directories(out_); }

void Report::add(const std::string& name, const Table& table) {
  print(table, std::cout);
  write_csv(table, record_, out_ / (name + ".csv"));
}

void Report::add(const std::string& name, const Plot& plot) {
  try {
    draw(plot, out_ / name);
  } catch (const PlotError& error) {
    std::fprintf(stderr, "regista: %s\n", error.what());
    complete_ = false;
  }
}

int Report::finish(const Checker& checker) const {
  std::cout << "tables and plots are in " << out_.string() << "; answers checked: " << checker.checked()
            << ", faulty: " << checker.faults() << std::endl;
  for (const std::string& text : checker.texts()) std::fprintf(stderr, "regista: faulty answer: %s\n", text.c_str());
  return complete_ && checker.faults() == 0 ? 0 : 1;
}

}  // namespace regista::bench
