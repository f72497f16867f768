// What the command lines of the benches share; for bench*.cc alone.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "modules/bench/record.h"
#include "modules/process/config.h"
#include "modules/regista/command.h"
#include "planning/registry.h"

namespace regista {

/// A bench's own options beside what all are told.
template <class Options>
struct BenchFlags {
  bench::Run run;
  Options options;
};

/// The subcommand with --out and --seed; calls measure(options, run).
template <class Options>
std::pair<CLI::App*, std::shared_ptr<BenchFlags<Options>>> add_one_bench(CLI::App& parent, Action& action,
                                                                         const char* name, const char* help,
                                                                         int (*measure)(const Options&,
                                                                                        const bench::Run&)) {
  CLI::App* command = parent.add_subcommand(name, help);
  const auto flags = std::make_shared<BenchFlags<Options>>();
  flags->run.command = bench::own_command_line();
  command->add_option("--out", flags->run.out, "folder for tables (CSV) and plots (SVG, PNG)")->capture_default_str();
  command->add_option("--seed", flags->run.seed, "of the random worlds and planners")->capture_default_str();
  command->callback([flags, measure, &action] {
    action = [flags, measure] {
      try {
        return measure(flags->options, flags->run);
      } catch (const UnknownPlanner& error) {
        throw UsageError(error.what());
      } catch (const ConfigError& error) {
        throw UsageError(error.what());
      }
    };
  });
  return {command, flags};
}

template <class T>
void add_count(CLI::App& command, const char* name, T& value, const char* help) {
  command.add_option(name, value, help)->capture_default_str()->check(CLI::Range(1.0, 1e9));
}

/// The benches of motion, which drive simulated teams.
void add_motion_benches(CLI::App& parent, Action& action);

}  // namespace regista
