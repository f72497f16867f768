// The two tables of times in "A Mapping & Planning Algorithm for RoboCup Small Size League" (2022).
#pragma once

#include "modules/bench/paper/paper.h"

namespace regista::bench {

/// 31 plannings behind a wall of robots.
int run_vis_wall(const PaperOptions& options, const Run& run);

/// 10,000 plannings among twelve agents.
int run_vis_agents(const PaperOptions& options, const Run& run);

}  // namespace regista::bench
