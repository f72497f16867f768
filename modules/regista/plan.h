// `regista plan`: plans queries from standard input, one JSON object per line.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_plan(CLI::App& app, Action& action);

}  // namespace regista
