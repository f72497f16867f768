// Is an answer what it claims to be? Asks planning/clearance.h for every leg and every obstacle, one by one: nothing of
// the fast tests that planners use, so that their faults are found.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "modules/bench/worlds.h"
#include "planning/plan.h"

namespace regista::bench {

/// What is wrong with an answer of status ok, by the laws in planning/planner.h; empty when nothing is, and for other
/// answers.
std::string fault_of(const World& world, const PlanRequest& request, const Plan& plan);

class Checker {
 public:
  /// False for a faulty answer, which is counted for that planner.
  bool check(const std::string& planner, const World& world, const PlanRequest& request, const Plan& plan);

  /// Counts answers, and a fault, that were checked elsewhere.
  void add_checked(std::size_t answers) { checked_ += answers; }
  void add_fault(const std::string& planner, const std::string& text);

  std::size_t checked() const { return checked_; }  ///< answers of status ok, and those counted
  std::size_t faults() const { return faults_; }
  std::size_t faults(const std::string& planner) const;
  /// The first few faults, one line each, with the query.
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::size_t checked_ = 0;
  std::size_t faults_ = 0;
  std::map<std::string, std::size_t> by_planner_;
  std::vector<std::string> texts_;
};

}  // namespace regista::bench
