// A planner as the tables of Costa & Tonidandel run it: theirs as published, ours beside.
#pragma once

#include "modules/bench/bench.h"
#include "modules/bench/paper/dvg_scenario.h"

namespace regista::bench {

struct Attempt {
  bool reached = false;
  double time_us = 0.0;
  std::vector<Vec2> path;  ///< to the goal, else as near to it as was found
  std::size_t tries = 1;   ///< trees that had to be grown
};

class Entrant {
 public:
  explicit Entrant(std::string name) : name_(std::move(name)) {}
  Entrant(const Entrant&) = delete;
  Entrant& operator=(const Entrant&) = delete;
  virtual ~Entrant() = default;

  const std::string& name() const { return name_; }

  /// One single shot: from the objects to the path. budget_us 0: no limit.
  virtual Attempt plan(const ObjectsQuery& query, std::uint64_t seed, double budget_us) = 0;

  /// Asks planning/clearance.h about the last answer, as far as its geometry lets it.
  virtual void check(const ObjectsQuery& query, const Attempt& attempt, Checker& checker) const = 0;

 private:
  std::string name_;
};

using Entrants = std::vector<std::unique_ptr<Entrant>>;

/// DVG+A* as published (planning/planners/dvg_published.h). Its octagons cut corners, it sees nothing outside the
/// active region, and its last edge may come as near to a robot as 90 mm, so only the ends of its path are checked;
/// touches_robot says the rest.
std::unique_ptr<Entrant> published_dvg(const std::string& name, const DvgParams& params);

/// RRT as published: no straight line is tried first; when N samples have not found a path, the next tree begins, and
/// the time of all of them counts ("the algorithm failed several times in a row, therefore, that single sample …",
/// section 7). Objects are the exact discs of r, but one that covers start or goal only as far as there.
std::unique_ptr<Entrant> published_rrt(const std::string& name, const RrtParams& params);

/// A planner of the registry on the exact discs.
std::unique_ptr<Entrant> registered(const std::string& planner);

/// dvg, rrt, and ours beside: tangent, visibility_sampling.
Entrants dvg_and_rrt_and_ours();
void add_ours(Entrants& entrants);

}  // namespace regista::bench
