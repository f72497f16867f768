#include "planning/planners/dvg.h"

#include "planning/planners/dvg_region.h"

namespace regista {
namespace {

constexpr double kWidening = 3.0;
/// From d_AR = 1 m to 2 km.
constexpr int kAttempts = 8;

}  // namespace

void Dvg::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  model(field, query, params_);
  dvg::End end = dvg::End::no_way;
  double half_width_m = params_.region_half_width_m;
  active_.clear();
  for (int i = 0; i < kAttempts && end == dvg::End::no_way && (i == 0 || active_.size() < polygons_.size()); ++i) {
    const dvg::ActiveRegion region(query.start, query.goal, half_width_m, half_width_m - params_.region_half_width_m);
    active_.clear();
    for (const dvg::Polygon& polygon : polygons_) {
      if (region.is_reached_by(polygon.vertices())) active_.push_back(polygon);
    }
    end = attempt(field, query, params_.edge_limit, result.path);
    half_width_m *= kWidening;
  }
  if (end == dvg::End::no_way && (params_.edge_limit || !enlarged_.empty())) {
    model(field, query, {});
    active_ = polygons_;
    end = attempt(field, query, false, result.path);
  }
  if (end == dvg::End::goal) {
    result.status = PlanStatus::ok;
  } else {
    result.reason = end == dvg::End::no_time ? "the time was spent" : "no way over the corners";
  }
}

void Dvg::model(const ObstacleField& field, const Query& query, const DvgParams& params) {
  polygons_.clear();
  discs_.clear();
  enlarged_.clear();
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (is_ignored(static_cast<ObstacleIndex>(i), query.ignored)) continue;
    const Obstacle& obstacle = field.obstacles()[i];
    if (obstacle.core == Core::point) {
      discs_.push_back({obstacle.a, obstacle.radius_m});
    } else {
      polygons_.push_back(dvg::polygon_around(obstacle));
    }
  }
  if (params.grouping) dvg::group_near(discs_, query.start, query.goal, params.group_distance_m);
  if (params.variable_radius) dvg::grow_far(discs_, query.start, query.goal, params);
  for (const dvg::Object& object : discs_) {
    const Obstacle around = disc(object.centre, object.radius_m);
    polygons_.push_back(dvg::polygon_around(around));
    if (object.is_enlarged) enlarged_.push_back(around);
  }
}

dvg::End Dvg::attempt(const ObstacleField& field, const Query& query, bool edge_limit, std::vector<Vec2>& path) {
  const dvg::IsFree is_free = [&](const Vec2& from, const Vec2& to, dvg::Edge) {
    const auto keeps_out = [&](const Obstacle& obstacle) { return regista::is_free(from, to, obstacle); };
    return field.is_free(from, to, query.ignored) && std::all_of(enlarged_.begin(), enlarged_.end(), keeps_out);
  };
  const bool complete = graph_.build(active_, query.start, query.goal, edge_limit, is_free, query.budget);
  if (graph_.shortest_path(path)) return dvg::End::goal;
  return complete ? dvg::End::no_way : dvg::End::no_time;
}

}  // namespace regista
