#include "modules/sim/sim_setup.h"

namespace regista {

SimSetup configured_setup(const Config& config, Time start) {
  SimSetup setup = sim_setup(config.scenario(), start);
  config.apply("sim", setup.params);
  return setup;
}

}  // namespace regista
