// DVG+A* of Costa & Tonidandel for a robot that drives: a visibility graph over the objects near the straight line, on
// the exact obstacles. The geometry as printed, for their tables, is dvg_published.h.
#pragma once

#include "planning/planner.h"
#include "planning/planners/dvg_graph.h"
#include "planning/planners/dvg_objects.h"
#include "planning/planning_params.h"

namespace regista {

/// What differs from the published geometry, so that the answer is free and rarely none:
/// - polygons stand around the grown obstacles (dvg_polygon.h) and an edge is free when the field says so, whatever
///   is in the active region; edges also keep out of groups and of discs that have grown. The goal is free, so it
///   needs no exception;
/// - where there is no path within the region, it is made three times as wide, and as much longer at both ends, until
///   it holds all objects; then the objects are taken as they are, without limit. (The paper says that there
///   practically always is one.)
class Dvg : public Planner {
 public:
  explicit Dvg(const PlanningParams& params = {}) : Dvg(params.dvg) {}
  explicit Dvg(const DvgParams& params) : params_(params) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  /// Obstacles as polygons_; discs may be grouped or grown into enlarged_.
  void model(const ObstacleField& field, const Query& query, const DvgParams& params);
  dvg::End attempt(const ObstacleField& field, const Query& query, bool edge_limit, std::vector<Vec2>& path);

  DvgParams params_;
  std::vector<dvg::Polygon> polygons_;
  std::vector<dvg::Polygon> active_;
  std::vector<dvg::Object> discs_;
  std::vector<Obstacle> enlarged_;
  dvg::Graph graph_;
};

/// The same with its own parameters: grouping is on.
class DvgGrouped : public Dvg {
 public:
  explicit DvgGrouped(const PlanningParams& params = {}) : Dvg(params.dvg_grouped) {}
};

}  // namespace regista
