// Figure 10 of Pinheiro, Maximo & Yoneyama (LARS 2020): an ideal tracker follows a path that is planned anew with every
// camera frame.
#pragma once

#include "modules/bench/paper/paper.h"

namespace regista::bench {

/// Distance to the goal against the replanning iteration, mean of all runs.
int run_sbp_tracking(const PaperOptions& options, const Run& run);

}  // namespace regista::bench
