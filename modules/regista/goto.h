// `regista goto`: sends one robot to a place.
#pragma once

#include "modules/regista/command.h"

namespace regista {

/// The action is set when the subcommand is called; it must outlive the parsing.
void add_goto(CLI::App& app, Action& action);

}  // namespace regista
