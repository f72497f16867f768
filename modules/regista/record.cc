#include "modules/regista/record.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <memory>

#include "modules/process/module_program.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/external_tool.h"

namespace regista {
namespace {

struct Flags {
  std::string lcm_url = default_lcm_url();
  std::string file;
  std::string channels = ".*";
  bool force = false;
};

std::string default_file() {
  const std::string name = fmt::format("regista-{:%Y-%m-%d-%H%M%S}.lcmlog", fmt::localtime(std::time(nullptr)));
  return std::filesystem::is_directory("logs") ? "logs/" + name : name;
}

/// Throws CommandError where lcm-logger could not write it, which it would tell only after the announcement.
void require_writable(const std::string& file) {
  const bool exists = std::filesystem::exists(file);
  if (exists && std::filesystem::is_directory(file)) throw CommandError(file + " is a folder: give a file in it");
  if (exists && !std::filesystem::is_regular_file(file)) return;  // a device; a pipe would wait for its reader
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC | (exists ? 0 : O_CREAT | O_EXCL), 0666);
  if (descriptor < 0) throw CommandError("cannot write " + file + ": " + std::strerror(errno));
  close(descriptor);
  if (!exists) unlink(file.c_str());  // lcm-logger wants to make it itself
}

int record(const Flags& flags) {
  const std::string file = flags.file.empty() ? default_file() : flags.file;
  if (!flags.force && std::filesystem::exists(file)) {
    throw CommandError(file + " exists: give another name, or --force to replace it");
  }
  require_writable(file);
  // Here, where it is one line: the bus may have no route.
  { const Bus bus(flags.lcm_url, real_clock()); }
  const std::string tool = find_tool("lcm-logger", "liblcm-bin");
  fmt::print(stderr, "recording to {}, end with Ctrl-C\n", file);
  // -l is broken in LCM 1.3.1, the long form works.
  std::vector<std::string> arguments{"--lcm-url=" + flags.lcm_url, "--channel=" + flags.channels, "--quiet"};
  if (flags.force) arguments.emplace_back("--force");
  arguments.insert(arguments.end(), {"--", file});
  become(tool, arguments);
}

}  // namespace

void add_record(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("record", "record the bus with lcm-logger until Ctrl-C");
  const auto flags = std::make_shared<Flags>();
  command->add_option("file", flags->file, "the log; without it a name with the date, in logs/ where that exists");
  command->add_option("--channels", flags->channels, "regular expression over whole channel names")
      ->capture_default_str();
  command->add_flag("-f,--force", flags->force, "replace an existing file");
  add_bus_flag(*command, flags->lcm_url);
  command->callback([flags, &action] { action = [flags] { return record(*flags); }; });
}

}  // namespace regista
