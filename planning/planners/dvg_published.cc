#include "planning/planners/dvg_published.h"

#include "planning/clearance.h"
#include "planning/planners/dvg_region.h"

namespace regista::dvg {
namespace {

bool covers(const Object& object, const Vec2& point) {
  return crosses_octagon(point, point, object.centre, object.radius_m);
}

bool blocks(const Object& object, const Vec2& from, const Vec2& to, Edge edge, const DvgParams& params) {
  const auto comes_nearer_than = [&](double least_m) {
    return (nearest_on_segment(object.centre, from, to) - object.centre).norm() < least_m - kTouch_m;
  };
  if (edge == Edge::to_goal && (params.exception_everywhere || covers(object, to))) {
    return comes_nearer_than(params.robot_radius_m);
  }
  if (edge != Edge::between_corners && covers(object, from)) {
    return comes_nearer_than(std::min(params.robot_radius_m, (from - object.centre).norm()));
  }
  return crosses_octagon(from, to, object.centre, object.radius_m);
}

}  // namespace

void find(std::span<const Object> objects, const Vec2& start, const Vec2& goal, const DvgParams& params, Graph& graph,
          Result& result, const Budget& budget) {
  const ActiveRegion region(start, goal, params.region_half_width_m);
  std::vector<Object> active;
  for (const Object& object : objects) {
    if (region.is_reached_by(octagon(object.centre, object.radius_m).vertices())) active.push_back(object);
  }
  if (params.grouping) group_near(active, start, goal, params.group_distance_m);
  if (params.variable_radius) grow_far(active, start, goal, params);
  std::vector<Polygon> polygons;
  polygons.reserve(active.size());
  for (const Object& object : active) polygons.push_back(octagon(object.centre, object.radius_m));
  const IsFree is_free = [&](const Vec2& from, const Vec2& to, Edge edge) {
    for (const Object& object : active) {
      if (blocks(object, from, to, edge, params)) return false;
    }
    return true;
  };
  const bool complete = graph.build(polygons, start, goal, params.edge_limit, is_free, budget);
  const bool found = graph.shortest_path(result.path);
  result.end = found ? End::goal : complete ? End::no_way : End::no_time;
  result.objects = active.size();
  result.nodes = graph.nodes();
  result.edges = graph.edges();
}

}  // namespace regista::dvg
