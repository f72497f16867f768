// What the command line needs before CLI11 reads it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace regista {

/// Without the program's name. "-.5" becomes "-0.5": CLI11 takes negative numbers that begin with a digit for values,
/// others for flags.
std::vector<std::string> arguments_of(int argc, const char* const* argv);

/// "unknown command 'foo', known: …" where a word stands in a command's place and names none, on any level.
std::optional<std::string> unknown_command(CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace regista
