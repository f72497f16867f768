// `regista run`: a scenario in one process, in lock step, with a summary, a log and a picture at the end.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_run(CLI::App& app, Action& action);

}  // namespace regista
