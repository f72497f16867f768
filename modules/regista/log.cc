#include "modules/regista/log.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "logs/log_compare.h"
#include "logs/log_info.h"

namespace regista {
namespace {

struct CompareFlags {
  std::string a;
  std::string b;
  std::string channels;
  double tolerance = 0.0;
};

int info(const std::string& file) {
  require_message(file);
  const LogInfo log = log_info(file);
  fmt::print("{}: {:.1f} kB, {} messages, {:.3f} s\n", file, static_cast<double>(log.file_bytes) / 1e3, log.messages,
             to_seconds(log.last - log.first));
  fmt::print("{:<24} {:>9} {:>9} {:>12}\n", "channel", "messages", "Hz", "bytes");
  for (const ChannelInfo& channel : log.channels) {
    fmt::print("{:<24} {:>9} {:>9.1f} {:>12}\n", channel.channel, channel.messages, rate_hz(channel), channel.bytes);
  }
  if (log.damaged_bytes > 0) {
    fmt::print("{} bytes belong to no whole message: the log is cut off or damaged\n", log.damaged_bytes);
  }
  return 0;
}

std::string largest(const ChannelComparison& channel) {
  return std::isinf(channel.largest_difference) ? "structure" : fmt::format("{:.3g}", channel.largest_difference);
}

int compare(const CompareFlags& flags, bool has_tolerance) {
  CompareOptions options{flags.channels, {}};
  if (has_tolerance) options.tolerance = flags.tolerance;
  const auto comparison = compare_logs(flags.a, flags.b, options);
  fmt::print("{:<24} {:>9} {:>9} {:>9} {:>9} {:>12}  {}\n", "channel", "matched", "different", "only in A", "only in B",
             "largest diff", "first different stamp");
  for (const ChannelComparison& channel : comparison) {
    fmt::print("{:<24} {:>9} {:>9} {:>9} {:>9} {:>12}  {}\n", channel.channel, channel.matched, channel.different,
               channel.only_in_a, channel.only_in_b, largest(channel),
               channel.first_different ? std::to_string(to_us(*channel.first_different)) : "-");
  }
  const bool same = all_match(comparison);
  fmt::print("{}\n", same ? "the logs match" : comparison.empty() ? "no such channels" : "the logs differ");
  return same ? 0 : 1;
}

}  // namespace

void add_log(CLI::App& app, Action& action) {
  CLI::App* log = app.add_subcommand("log", "look into LCM logs");
  log->require_subcommand(1);

  CLI::App* info_command = log->add_subcommand("info", "channels, counts, rates, duration, size");
  const auto file = std::make_shared<std::string>();
  info_command->add_option("file", *file, "the log")->required();
  info_command->callback([file, &action] { action = [file] { return info(*file); }; });

  CLI::App* compare_command =
      log->add_subcommand("compare", "messages of the same channel and stamp; exit status 1 when the logs differ");
  const auto flags = std::make_shared<CompareFlags>();
  compare_command->add_option("a", flags->a, "a log")->required();
  compare_command->add_option("b", flags->b, "another")->required();
  compare_command->add_option("--channels", flags->channels,
                              "regular expression over whole names; without it all but TIMING and STATUS");
  CLI::Option* tolerance =
      compare_command
          ->add_option("--tolerance", flags->tolerance,
                       "largest difference of any number, counters left out; without it the bytes must be the same")
          ->check(CLI::NonNegativeNumber);
  compare_command->callback([flags, tolerance, &action] {
    action = [flags, has_tolerance = tolerance->count() > 0] { return compare(*flags, has_tolerance); };
  });
}

}  // namespace regista
