// `regista bench`: measures the planners; what each bench does is in modules/bench/.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_bench(CLI::App& app, Action& action);

}  // namespace regista
