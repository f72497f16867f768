#include "modules/regista/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>

namespace regista {
namespace {

bool is_number_without_leading_digit(const std::string& text) {
  if (!text.starts_with("-.") || text.size() < 3 || text[2] < '0' || text[2] > '9') return false;
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return *end == '\0';
}

}  // namespace

std::vector<std::string> arguments_of(int argc, const char* const* argv) {
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) {
    std::string argument = argv[i];
    if (is_number_without_leading_digit(argument)) argument.insert(1, "0");
    arguments.push_back(std::move(argument));
  }
  return arguments;
}

std::optional<std::string> unknown_command(CLI::App& app, const std::vector<std::string>& arguments) {
  CLI::App* level = &app;
  for (const std::string& argument : arguments) {
    const auto commands = level->get_subcommands([](CLI::App*) { return true; });
    if (commands.empty() || argument.starts_with('-')) return std::nullopt;
    const auto next = std::find_if(commands.begin(), commands.end(),
                                   [&](const CLI::App* command) { return command->check_name(argument); });
    if (next == commands.end()) {
      std::string known;
      for (const CLI::App* command : commands) known += (known.empty() ? "" : ", ") + command->get_name();
      return "unknown command '" + argument + "', known: " + known;
    }
    level = *next;
  }
  return std::nullopt;
}

}  // namespace regista
