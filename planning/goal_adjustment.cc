#include "planning/goal_adjustment.h"

#include <algorithm>

namespace regista {
namespace {

/// Rounding may put a point on the bounds a hair outside; touching is free, but nobody need see it.
Vec2 clamped(const Vec2& point, const Bounds& bounds) {
  return point.cwiseMax(-bounds.half_extent_m).cwiseMin(bounds.half_extent_m);
}

/// How far the point lies out of bounds.
double outside_m(const Vec2& point, const Bounds& bounds) { return (point - clamped(point, bounds)).norm(); }

}  // namespace

std::optional<Vec2> GoalAdjustment::nearest_free_point(const ObstacleField& field, const Vec2& point,
                                                       std::span<const std::size_t> ignored) {
  return nearest(field, point, ignored, false);
}

std::optional<Vec2> GoalAdjustment::way_out(const ObstacleField& field, const Vec2& start,
                                            std::span<const std::size_t> ignored) {
  return nearest(field, start, ignored, true);
}

std::optional<Vec2> GoalAdjustment::nearest(const ObstacleField& field, const Vec2& point,
                                            std::span<const std::size_t> ignored, bool is_way_out) {
  field_ = &field;
  ignored_ = ignored;
  from_ = point;
  is_way_out_ = is_way_out;
  find_covering();
  if (covering_.empty() && is_inside(point, field.bounds())) return point;
  return nearest_on_outlines();
}

/// The nearest admitted point lies on a border (see is_border) as the projection of from_, or where the border meets
/// another outline (or, for a way out, a straight line that grazes an obstacle).
std::optional<Vec2> GoalAdjustment::nearest_on_outlines() {
  best_m_ = shadowed_m_ = std::numeric_limits<double>::infinity();
  best_.reset();
  nearest_.clear();
  if (!try_deepest()) {
    const double all_m = farthest_border_m();
    constexpr double kBeyond_m = 0.5;  // two robots' radii and as much again
    double radius_m = deepest_m_ + kBeyond_m;
    const auto try_all = [&](bool with_rays) {
      while (!try_within(radius_m, with_rays) && radius_m < all_m) radius_m = is_way_out_ ? all_m : 4.0 * radius_m;
    };
    try_all(false);
    // Where a shadow's border is nearest, following the outline into the shadow leads nearer still, to another point.
    if (shadowed_m_ < best_m_) try_all(true);
  }
  if (best_) best_ = clamped(*best_, field_->bounds());
  return best_;
}

void GoalAdjustment::find_covering() {
  covering_.clear();
  field_->covering(from_, covering_);
  std::erase_if(covering_, [this](ObstacleIndex i) { return is_ignored(i, ignored_); });
  crossed_.assign(ignored_.begin(), ignored_.end());
  if (!is_way_out_) return;
  crossed_.insert(crossed_.end(), covering_.begin(), covering_.end());
  std::sort(crossed_.begin(), crossed_.end());
}

/// A way out ends as soon as it has left all that covers the start: on one of these outlines, however many obstacles
/// stand around. The nearest free point may lie on any.
bool GoalAdjustment::is_border(ObstacleIndex obstacle) const {
  return !is_way_out_ || std::find(covering_.begin(), covering_.end(), obstacle) != covering_.end();
}

double GoalAdjustment::farthest_border_m() const {
  if (!is_way_out_) return farthest_m(from_, outline_of(field_->bounds()));
  double all_m = farthest_m(from_, entry_of(field_->bounds(), from_));
  for (const ObstacleIndex i : covering_) {
    all_m = std::max(all_m, farthest_m(from_, outline_of(field_->obstacles()[i])));
  }
  return all_m;
}

bool GoalAdjustment::admits(const Vec2& candidate, double distance_m) {
  if (!is_way_out_) return field_->is_free(candidate, ignored_);
  const auto covers = [&](ObstacleIndex i) { return !is_free(candidate, candidate, field_->obstacles()[i]); };
  if (!is_inside(candidate, field_->bounds()) || std::any_of(covering_.begin(), covering_.end(), covers)) return false;
  if (!is_in_shadow(candidate)) return field_->is_free(candidate, ignored_);
  if (distance_m < shadowed_m_ && field_->is_free(candidate, ignored_)) shadowed_m_ = distance_m;
  return false;
}

/// Of a start without a way out all candidates are tried; what stands right at it blocks most of them.
bool GoalAdjustment::is_in_shadow(const Vec2& candidate) const {
  const auto blocks = [&](ObstacleIndex i) { return !is_free(from_, candidate, field_->obstacles()[i]); };
  return std::any_of(nearest_.begin(), nearest_.end(), blocks) || field_->first_blocker(from_, candidate, crossed_);
}

/// Nothing is nearer than the boundary of what covers the point deepest; mostly its nearest point is free.
bool GoalAdjustment::try_deepest() {
  const Bounds& bounds = field_->bounds();
  deepest_m_ = outside_m(from_, bounds);
  candidates_.clear();
  append_projections(from_, outline_of(bounds), candidates_);
  for (const ObstacleIndex i : covering_) {
    const Obstacle& obstacle = field_->obstacles()[i];
    const double depth_m = -clearance(from_, obstacle);
    if (depth_m <= deepest_m_) continue;
    deepest_m_ = depth_m;
    candidates_.clear();
    append_projections(from_, outline_of(obstacle), candidates_);
  }
  constexpr double kRounding_m = 1e-12;
  for (const Vec2& candidate : candidates_) {
    const double distance_m = (candidate - from_).norm();
    if (distance_m > deepest_m_ + kRounding_m || !admits(candidate, distance_m)) continue;
    best_ = candidate;
    return true;
  }
  return false;
}

/// Nothing of its outline is free: a goal's walls lie in its defence area. (A way out may have to graze one, though.)
bool GoalAdjustment::is_held(ObstacleIndex obstacle) const {
  return std::any_of(covering_.begin(), covering_.end(), [&](ObstacleIndex i) {
    return i != obstacle && surely_holds(field_->obstacles()[i], field_->obstacles()[obstacle]) &&
           !surely_holds(field_->obstacles()[obstacle], field_->obstacles()[i]);
  });
}

/// With the outlines that come within the radius, in the order of their distance; as soon as the next one is farther
/// than the best point so far, nothing better can come. False when the best may be farther than the radius.
bool GoalAdjustment::try_within(double radius_m, bool with_rays) {
  order_.clear();
  field_->maybe_within(from_, radius_m, [&](ObstacleIndex i) {
    if (is_ignored(i, ignored_) || (is_border(i) && is_held(i))) return;
    const double distance_m = std::abs(clearance(from_, field_->obstacles()[i]));
    if (distance_m <= radius_m) order_.emplace_back(distance_m, i);
  });
  std::sort(order_.begin(), order_.end());
  find_nearest();
  added_.clear();
  borders_.clear();
  add(outline_of(field_->bounds()), !is_way_out_);
  if (is_way_out_) add(entry_of(field_->bounds(), from_), true);
  for (const auto& [distance_m, index] : order_) {
    if (distance_m > best_m_) break;
    const Outline outline = outline_of(field_->obstacles()[index]);
    const bool border = is_border(index);
    if (with_rays && !border) add_rays(outline);
    add(outline, border);
  }
  return best_m_ <= radius_m;
}

void GoalAdjustment::find_nearest() {
  constexpr std::size_t kNearest = 8;  // as many as stand around a robot
  nearest_.clear();
  for (std::size_t i = 0; i < order_.size() && nearest_.size() < kNearest; ++i) {
    if (!is_border(order_[i].second)) nearest_.push_back(order_[i].second);
  }
}

void GoalAdjustment::add(const Outline& outline, bool border) {
  candidates_.clear();
  if (border) append_projections(from_, outline, candidates_);
  for (const Outline& other : border ? added_ : borders_) append_intersections(outline, other, candidates_);
  added_.push_back(outline);
  if (border) borders_.push_back(outline);
  try_candidates();
}

void GoalAdjustment::add_rays(const Outline& outline) {
  rays_.clear();
  const double length_m = 2.0 * (field_->bounds().half_extent_m.norm() + from_.norm());
  append_tangents(from_, outline, length_m, rays_);
  for (const Outline& ray : rays_) add(ray, false);
}

void GoalAdjustment::try_candidates() {
  for (const Vec2& candidate : candidates_) {
    const double distance_m = (candidate - from_).norm();
    if (distance_m >= best_m_ || !admits(candidate, distance_m)) continue;
    best_m_ = distance_m;
    best_ = candidate;
  }
}

}  // namespace regista
