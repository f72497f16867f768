// The simulator's setup from a configuration: the scenario's field, formation and preset, [sim] over the preset.
#pragma once

#include "modules/process/config.h"
#include "sim/simulator.h"

namespace regista {

/// Throws ConfigError.
SimSetup configured_setup(const Config& config, Time start);

}  // namespace regista
