// `regista log`: what is in an LCM log, and whether two of them say the same.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_log(CLI::App& app, Action& action);

}  // namespace regista
