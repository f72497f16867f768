// Artificial potential field: the goal attracts, obstacles repel (Khatib 1986), and a local minimum is left by
// following the obstacle's wall (Yun & Tan, "A wall-following method for escaping local minima in potential field based
// motion planning", 1997). The "APF" of the iterative RRT paper, which does not say how its own leaves them.
#pragma once

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

/// The whole way is driven beforehand in small steps, each free by the field's exact test:
/// - downhill, until nothing gets nearer to the goal any more;
/// - then straight towards the goal, until an obstacle is met (or the field leads on);
/// - then along that obstacle, on both sides in turn, until the goal is nearer than where it was met and the way to it
///   begins free; the side with the shorter way is taken.
/// Every round ends nearer to the goal than it began, so it ends. Not complete: what is narrower than a step may be
/// missed, and a wall that leads round to where it was met ends the search. Not optimal. Nothing is random.
class Apf : public Planner {
 public:
  explicit Apf(const PlanningParams& params = {}) : Apf(params.apf) {}
  explicit Apf(const ApfParams& params) : params_(params) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  ApfParams params_;
};

}  // namespace regista
