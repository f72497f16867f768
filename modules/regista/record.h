// `regista record`: records the bus with lcm-logger.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_record(CLI::App& app, Action& action);

}  // namespace regista
