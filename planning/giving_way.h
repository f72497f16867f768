// Where two of a team are in each other's only way, as head-on in a corridor, one of them leaves the other's way until
// that has passed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planning/planner.h"

namespace regista {

/// A robot gives way when it is proved to have no way (unreachable), has one if no team-mate stood anywhere, and on
/// that meets a team-mate that is still under way. Of two that meet each other so, it is the one with the shorter way
/// out; as it goes, its way gets shorter, so it stays the one. The answer depends on the arguments alone.
class GivingWay {
 public:
  /// One of the team with a plan: obstacle `obstacle` of the field.
  struct Traveller {
    std::size_t obstacle = 0;
    PlanRequest request;  ///< what was planned, all others as obstacles
    Plan* plan = nullptr;
  };

  /// Whoever gives way gets a plan to the nearest place where it does not stand in the other's way, at most within_m
  /// from here (0: nobody gives way); its status stays, the reason says for whom. `mates` are the sorted indices of the
  /// team's obstacles.
  void resolve(Planner& planner, graph::SharedGraph& graph, std::span<Traveller> travellers,
               std::span<const std::size_t> mates, double within_m);

 private:
  PlanRequest without_mates(std::size_t traveller) const;
  const Plan& way_of(std::size_t traveller);
  bool closes_alone(std::size_t traveller, std::size_t other);
  std::optional<std::size_t> first_met(std::size_t traveller);
  std::optional<Plan> way_out(std::size_t traveller, std::span<const Vec2> of_other);
  bool yields(std::size_t traveller, std::size_t other, double length_m);

  /// Of the call that runs.
  Planner* planner_ = nullptr;
  graph::SharedGraph* graph_ = nullptr;
  std::span<Traveller> travellers_;
  std::span<const std::size_t> mates_;
  double within_m_ = 0.0;
  std::vector<std::optional<Plan>> ways_;  ///< by traveller: as if no team-mate stood anywhere
};

}  // namespace regista
