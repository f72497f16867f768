#include "modules/regista/replay.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "logs/log_reader.h"
#include "logs/module_channels.h"
#include "modules/process/module_program.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/external_tool.h"

namespace regista {
namespace {

struct Flags {
  std::string lcm_url = default_lcm_url();
  std::string file;
  double speed = 1.0;
  std::vector<std::string> into;
  std::vector<std::string> without;
};

/// The channels to play, as lcm-logplayer's expression.
std::string channels_to_play(const Flags& flags) {
  std::vector<std::string> left_out = flags.without;
  try {
    for (const std::string& module : flags.into) {
      for (const std::string& pattern : outputs_of(module)) left_out.push_back(pattern);
    }
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--into: ") + error.what());
  }
  // Requests are played again, the fresh modules answer them themselves.
  if (!flags.into.empty()) left_out.emplace_back("REPLY");
  return all_but(left_out);
}

int replay(const Flags& flags) {
  const std::string channels = channels_to_play(flags);
  { const LogReader readable(flags.file); }
  const std::string file = std::filesystem::absolute(flags.file).string();
  // lcm-logplayer puts the name into a URL.
  if (file.find('?') != std::string::npos)
    throw CommandError(file + ": lcm-logplayer takes no '?' in a name, rename it");
  { const Bus bus(flags.lcm_url, real_clock()); }
  const std::string tool = find_tool("lcm-logplayer", "liblcm-bin");
  require_message(file);
  become(tool,
         {"--speed=" + fmt::format("{}", flags.speed), "--regexp=" + channels, "--lcm-url=" + flags.lcm_url, file});
}

}  // namespace

void add_replay(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("replay", "play a log to the bus with lcm-logplayer");
  const auto flags = std::make_shared<Flags>();
  command->add_option("file", flags->file, "the log")->required();
  command->add_option("--speed", flags->speed, "1: as fast as recorded")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1000.0));
  command
      ->add_option("--into", flags->into,
                   "modules that run afresh, as world-model,planner.Y: their recorded outputs are left out")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--without", flags->without,
                   "channels to leave out (regular expression, whole names); may be repeated")
      ->allow_extra_args(false);
  add_bus_flag(*command, flags->lcm_url);
  command->callback([flags, &action] { action = [flags] { return replay(*flags); }; });
}

}  // namespace regista
