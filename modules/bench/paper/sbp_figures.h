// Figures 6 to 9 of Pinheiro, Maximo & Yoneyama, "Comparison of Sampling-based Path Planners for Robocup Small Size
// League" (LARS 2020).
#pragma once

#include "modules/bench/paper/paper.h"

namespace regista::bench {

/// Success and standard deviation of the length against the samples per batch, within the time of equation 2.
int run_sbp_batches(const PaperOptions& options, const Run& run);

/// Success and length against the allowed time.
int run_sbp_times(const PaperOptions& options, const Run& run);

}  // namespace regista::bench
