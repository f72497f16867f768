// `regista replay`: plays a log to the bus with lcm-logplayer, without what fresh modules shall publish themselves.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_replay(CLI::App& app, Action& action);

}  // namespace regista
