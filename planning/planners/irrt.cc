#include "planning/planners/irrt.h"

#include <algorithm>

#include "planning/planners/rrt_tree.h"
#include "planning/polyline.h"

namespace regista {
namespace {

constexpr std::int64_t kShareOfARectangle = 8;  ///< one part in eight of the samples that remain

class SearchRectangle {
 public:
  SearchRectangle(const Query& query, const Bounds& bounds, double width_m)
      : middle_(0.5 * (query.start + query.goal)), bounds_(bounds), half_width_m_(0.5 * width_m) {
    const Vec2 way = query.goal - query.start;
    half_length_m_ = 0.5 * way.norm() + half_width_m_;
    along_ = way.normalized();
  }

  bool holds_the_field() const { return half_width_m_ >= 2.0 * bounds_.half_extent_m.norm(); }

  /// Uniform in what it has in common with the field.
  Vec2 draw(std::mt19937_64& random) const {
    if (holds_the_field()) return uniform_point(random, bounds_);
    const Vec2 across(-along_.y(), along_.x());
    // Half of it or more lies within the field wherever start and goal are; a sliver of a field must not hang us.
    constexpr int kTries = 32;
    Vec2 point = middle_;
    for (int i = 0; i < kTries; ++i) {
      const double forward = uniform(random, -half_length_m_, half_length_m_);
      const double left = uniform(random, -half_width_m_, half_width_m_);
      point = middle_ + forward * along_ + left * across;
      if (is_inside(point, bounds_)) return point;
    }
    return point.cwiseMax(-bounds_.half_extent_m).cwiseMin(bounds_.half_extent_m);
  }

 private:
  Vec2 middle_;
  Vec2 along_;
  Bounds bounds_;
  double half_length_m_ = 0.0;
  double half_width_m_ = 0.0;
};

class Search {
 public:
  Search(const ObstacleField& field, const Query& query, const IterativeRrtParams& params)
      : field_(field), query_(query), params_(params), random_(query.seed) {}

  /// The better one of two trees within the rectangle, as a branch from start to goal.
  RrtBranch within(const SearchRectangle& rectangle, std::int64_t samples) {
    RrtBranch forward = grow(query_, rectangle, samples - samples / 2);
    if (forward.end == RrtEnd::no_time) return forward;
    Query reversed = query_;
    std::swap(reversed.start, reversed.goal);
    RrtBranch backward = grow(reversed, rectangle, samples / 2);
    if (backward.end != RrtEnd::goal) {
      if (forward.end != RrtEnd::goal) forward.end = backward.end;
      return forward;
    }
    if (forward.end == RrtEnd::goal && length_of(forward.path) <= length_of(backward.path)) return forward;
    std::reverse(backward.path.begin(), backward.path.end());
    return backward;
  }

 private:
  RrtBranch grow(const Query& query, const SearchRectangle& rectangle, std::int64_t samples) {
    const auto choose_target = [&] {
      return uniform(random_) < params_.goal_bias ? query.goal : rectangle.draw(random_);
    };
    const RrtSteps steps{.step_m = params_.epsilon_m, .goal_reach_m = params_.epsilon_m};
    return grow_rrt(field_, query, steps, samples, choose_target);
  }

  const ObstacleField& field_;
  const Query& query_;
  const IterativeRrtParams& params_;
  std::mt19937_64 random_;
};

}  // namespace

void Irrt::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if (answered_without_tree(field, query, result)) return;
  Search search(field, query, params_);
  std::int64_t remaining = query.budget.iterations;
  for (double width_m = params_.first_width_m;; width_m *= 2.0) {
    const SearchRectangle rectangle(query, field.bounds(), width_m);
    const std::int64_t samples = rectangle.holds_the_field() ? remaining : remaining / kShareOfARectangle;
    RrtBranch branch = search.within(rectangle, samples);
    remaining -= samples;
    if (branch.end == RrtEnd::samples_spent && !rectangle.holds_the_field()) continue;
    return answer_with(std::move(branch), result);
  }
}

void IrrtSmooth::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  Irrt::search(graph, query, result);
  result.path = pruned(graph.field(), result.path, query.ignored);
}

}  // namespace regista
