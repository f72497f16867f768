// `regista referee`: says what the referee says, where the league's own referee is not heard.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_referee(CLI::App& app, Action& action);

}  // namespace regista
