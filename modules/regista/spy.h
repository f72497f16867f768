// `regista spy`: starts lcm-spy with this project's message types.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_spy(CLI::App& app, Action& action);

}  // namespace regista
