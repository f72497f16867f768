// `regista planner`: lists the planners and swaps them while the robots drive.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_planner(CLI::App& app, Action& action);

}  // namespace regista
