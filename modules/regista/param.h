// `regista param`: lists, reads and sets a running module's parameters.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_param(CLI::App& app, Action& action);

}  // namespace regista
