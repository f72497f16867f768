// `regista up`: starts the modules of a scenario as processes, watches and restarts them, shows a table of them.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_up(CLI::App& app, Action& action);

}  // namespace regista
