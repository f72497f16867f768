// The bench framework in one include. How a bench is written:
//
//   int run_mine(const MyOptions& options, const Run& run) {
//     Report report(run);                                   // folder, seed and command line of this run
//     Checker checker;                                      // every answer "ok" goes through it
//     Contenders all = make_contenders({"tangent", "rrt"}); // planner, graph of its own, scratch
//     Progress progress("mine", queries);
//     for (std::size_t i = 0; i < queries; ++i) {
//       std::mt19937_64 random(mixed(run.seed, i));         // a query is a function of seed and number
//       const Scene scene = eleven_against_eleven(random);
//       for (std::size_t k : rotated(all.size(), i)) {      // all planners one after another, in rotating order
//         const Shot shot = plan_once(all[k], scene.world, scene.request, budget_us);
//         checker.check(all[k].name, scene.world, scene.request, all[k].answer);
//         samples[k].push_back(shot.total_us);              // single shots, nothing subtracted, no minimum taken
//       }
//       progress.advance();
//     }
//     Table table{"title", {{"planner"}, {"mean", "us"}}};  // columns: name, unit, digits
//     table.add({all[k].name, summarise(samples[k]).mean}); // cells: text, integer, double or none ({})
//     report.add("mine", table);                            // prints it, writes <out>/mine.csv with the record
//     report.add("mine_time", Plot{...});                   // <out>/mine_time.dat, .gp, .svg, .png
//     return report.finish(checker);                        // 1 where an answer was faulty or a plot was not drawn
//   }
//
// Its command line is in modules/regista/bench.cc.
#pragma once

#include "modules/bench/checker.h"    // IWYU pragma: export
#include "modules/bench/contender.h"  // IWYU pragma: export
#include "modules/bench/fit.h"        // IWYU pragma: export
#include "modules/bench/plot.h"       // IWYU pragma: export
#include "modules/bench/progress.h"   // IWYU pragma: export
#include "modules/bench/record.h"     // IWYU pragma: export
#include "modules/bench/report.h"     // IWYU pragma: export
#include "modules/bench/stopwatch.h"  // IWYU pragma: export
#include "modules/bench/summary.h"    // IWYU pragma: export
#include "modules/bench/table.h"      // IWYU pragma: export
#include "modules/bench/worlds.h"     // IWYU pragma: export
