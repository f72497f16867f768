// Table I of the iterative RRT-Smooth paper: time and length of six planners on one map.
#pragma once

#include "modules/bench/paper/paper.h"
#include "modules/bench/worlds.h"

namespace regista::bench {

inline constexpr const char* kIrrtFile = "irrt_table1.toml";

/// The map as rebuilt in the data file.
Scene irrt_scene();

int run_irrt_table1(const PaperOptions& options, const Run& run);

}  // namespace regista::bench
