// What the user can set of planning: margins, moving obstacles, budgets. One list of fields, one place of defaults.
#pragma once

#include "planning/planners/apf_params.h"
#include "planning/planners/astar_grid_params.h"
#include "planning/planners/dvg_params.h"
#include "planning/planners/errt_params.h"
#include "planning/planners/ompl/ompl_params.h"
#include "planning/planners/rrt_params.h"
#include "planning/rule_params.h"
#include "world_model/params.h"

namespace regista {

struct PlanningParams {
  double robot_radius_m = 0.09;     ///< the largest legal body (SSL rules, "Robot shape")
  double team_margin_m = 0.03;      ///< between bodies of one team; 0.05 drives half a percent fewer targets
  double opponent_margin_m = 0.02;  ///< to opponents' bodies; control keeps what their motion asks for
  double area_margin_m = 0.01;      ///< between a body and a defence area
  double wall_margin_m = 0.005;     ///< between a body and the goals' walls
  double stretch_horizon_s = 0.0;   ///< moving robots become capsules this far along their velocity; 0: discs
  double stretch_max_m = 1.0;       ///< cap of that length
  /// Others are planned around where they will be at the nearest approach, at most so far ahead: what resolves most
  /// deadlocks, and drives 6 % more targets. Opponents turn sooner than team-mates, which are wanted on circles and
  /// whose goals are known. Both 0: everybody where he is, and the whole team shares one graph.
  double prediction_horizon_s = 0.5;
  double team_prediction_horizon_s = 2.0;
  /// For the moment of nearest approach a robot is expected to drive straight to its goal at this speed, about the mean
  /// of a drive. Its present velocity, which a robot that turns is about to leave, drives 4 % fewer targets.
  double prediction_speed_mps = 2.5;
  /// Twice what robots accelerate with: where others are met, a turn is mostly not over yet. 0, to turn at once, drives
  /// half a percent fewer targets.
  double prediction_turn_mps2 = 6.0;
  /// Opponents shrink in the plan with the way they go until they are met: from here on, and are gone after so much
  /// more. Where they will be then nobody knows, and to go around it costs 1 % of the targets. fade_over 0: they do
  /// not.
  double opponent_fade_from_m = 0.6;
  double opponent_fade_over_m = 2.0;
  double growth_radius_max_m = 0.0;        ///< robots far from the goal grow up to this radius; 0: they do not
  double growth = 0.05;                    ///< metres of radius per metre farther away, as in DvgParams
  double growth_unchanged_within_m = 1.0;  ///< no growth this near to the goal (d4 of figure 25)
  /// Keeping to a side costs targets among moving robots (0.05: 5 %, 0.2: 10 %): what moves is better passed on the
  /// other side soon. In the main job 0.2 takes away a fifth of the changes within 0.2 s.
  double side_change_gain = 0.0;
  /// A robot that has no way because of a team-mate gets out of that one's way, as in a corridor: at most so far; 0: it
  /// waits where it is. Half a field, so that there is a place wherever there is one.
  double give_way_within_m = 4.0;
  std::int64_t iterations = 2500;         ///< samples a random planner may draw (N of Costa & Tonidandel)
  std::int64_t anytime_iterations = 200;  ///< where no time ends an anytime planner: about a millisecond of RRT*
  std::int64_t budget_us = 0;             ///< time per robot; 0: a random planner's is its share of frame_period_s
  double frame_period_s = 0.01;           ///< of the cameras; 0: unknown, and no limit comes from it
  std::int64_t seed = 1;                  ///< of random planners
  RuleParams rules;
  RrtParams rrt;
  IterativeRrtParams irrt;
  ErrtParams errt;
  OmplParams ompl;
  DvgParams dvg;
  DvgParams dvg_grouped = grouped_dvg_params();
  AstarGridParams astar_grid;
  ApfParams apf;
  bool operator==(const PlanningParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("robot_radius_m", self.robot_radius_m, Range{0.01, 1.0}, "m", "radius of every robot's body");
    v("team_margin_m", self.team_margin_m, Range{0.0, 1.0}, "m", "kept between team-mates");
    v("opponent_margin_m", self.opponent_margin_m, Range{0.0, 1.0}, "m", "kept to opponents");
    v("area_margin_m", self.area_margin_m, Range{0.0, 1.0}, "m", "kept to defence areas");
    v("wall_margin_m", self.wall_margin_m, Range{0.0, 1.0}, "m", "kept to the goals' walls");
    v("stretch_horizon_s", self.stretch_horizon_s, Range{0.0, 2.0}, "s",
      "moving robots are stretched this far along their velocity; 0: not");
    v("stretch_max_m", self.stretch_max_m, Range{0.0, 5.0}, "m", "longest stretch of a moving robot");
    v("prediction_horizon_s", self.prediction_horizon_s, Range{0.0, 5.0}, "s",
      "opponents are expected where they will be at the nearest approach, at most so far ahead; 0: where they are");
    v("team_prediction_horizon_s", self.team_prediction_horizon_s, Range{0.0, 5.0}, "s", "the same for team-mates");
    v("prediction_speed_mps", self.prediction_speed_mps, Range{0.0, 20.0}, "m/s",
      "at which a robot is expected to drive to its goal, for the nearest approach");
    v("prediction_turn_mps2", self.prediction_turn_mps2, Range{0.0, 1000.0}, "m/s^2",
      "by which it gets there from the velocity it has; 0: at once");
    v("opponent_fade_from_m", self.opponent_fade_from_m, Range{0.0, 100.0}, "m",
      "opponents shrink with their way until the nearest approach, from this on");
    v("opponent_fade_over_m", self.opponent_fade_over_m, Range{0.0, 100.0}, "m",
      "and are gone after so much more of it; 0: they do not shrink");
    v("growth_radius_max_m", self.growth_radius_max_m, Range{0.0, 10.0}, "m",
      "robots grow with their distance from the goal, up to this radius (own body and margin included); 0: not");
    v("growth", self.growth, Range{0.0, 1.0}, "", "radius gained per distance from the goal");
    v("growth_unchanged_within_m", self.growth_unchanged_within_m, Range{0.0, 100.0}, "m",
      "no growth this near to the goal");
    v("side_change_gain", self.side_change_gain, Range{0.0, 10.0}, "",
      "the way around an obstacle on the side followed is kept while at most this share longer than another; 0: not");
    v("give_way_within_m", self.give_way_within_m, Range{0.0, 100.0}, "m",
      "how far a robot goes to leave the way of a team-mate that leaves it none; 0: it waits");
    v("iterations", self.iterations, Range{0.0, 1e9}, "", "samples a random planner may draw per robot");
    v("anytime_iterations", self.anytime_iterations, Range{0.0, 1e9}, "",
      "the same for planners that use whatever they get (RRT*, BIT*), where no time limit holds, as in lock step");
    v("budget_us", self.budget_us, Range{0.0, 1e9}, "us",
      "time for one robot's plan; 0: frame_period_s / robots of the team for random planners, no limit for others");
    v("frame_period_s", self.frame_period_s, Range{0.0, 10.0}, "s",
      "of the cameras, for budget_us; 0: no limit (lock step, which has no clock, always sets both to 0)");
    v("seed", self.seed, Range{0.0, 9e15}, "", "seed of random planners");
    v.group("rules", self.rules);
    v.group("rrt", self.rrt);
    v.group("irrt", self.irrt);
    v.group("errt", self.errt);
    v.group("ompl", self.ompl);
    v.group("dvg", self.dvg);
    v.group("dvg_grouped", self.dvg_grouped);
    v.group("astar_grid", self.astar_grid);
    v.group("apf", self.apf);
  }
};

}  // namespace regista
