// The contract of a planner as a test that any implementation can be put to.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "planning/registry.h"

namespace regista::testing {

/// One line for each broken law, with the seed or the world it was broken in; empty when the planner conforms. `worlds`
/// is how many random worlds it is put into.
std::vector<std::string> broken_laws(const std::function<std::unique_ptr<Planner>()>& make,
                                     const Guarantees& guarantees, int worlds);

}  // namespace regista::testing
