// Where obstacles overlap: which stretches of an obstacle's boundary lie inside others or out of bounds, so that no
// path can run there. Found when first asked for, kept for all robots of the frame.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "planning/graph/body.h"
#include "planning/obstacle_field.h"

namespace regista::graph {

/// Stands for the bounds where an obstacle's index is expected.
inline constexpr ObstacleIndex kBounds = std::numeric_limits<ObstacleIndex>::max();

/// From one order to another, counter-clockwise, the boundary lies inside `other`.
struct Cut {
  double from = 0.0;
  double to = 0.0;
  ObstacleIndex other = 0;
  bool is_whole = false;  ///< all of the boundary
};

/// An arc leaves as a circumscribed polyline that is longer by at most this share; each of its legs spans that angle:
/// tan(x/2)/(x/2) - 1 ≈ x²/12.
inline constexpr double kArcExcess = 1e-3;
inline constexpr double kArcStep_rad = 0.1094;
/// And its vertices lie outside of the arc by at most this share of the radius: 1/cos(x/2) - 1.
inline constexpr double kArcOvershoot = 1.51e-3;

class Contacts {
 public:
  /// Forgets everything; the number of obstacles of the new field.
  void reset(std::size_t obstacles);

  struct Of {
    std::span<const Cut> cuts;
    std::span<const ObstacleIndex> brushes;  ///< others (or kBounds) so near that a polyline's vertex may touch them
  };

  /// Valid until the next call.
  Of of(const ObstacleField& field, ObstacleIndex obstacle, const Body& body);

 private:
  struct Range {
    std::uint32_t cuts_begin = 0, cuts_end = 0, brushes_begin = 0, brushes_end = 0;
    bool is_known = false;
  };

  void find(const ObstacleField& field, ObstacleIndex obstacle, const Body& body);
  void add_disc(const Obstacle& disc, const Obstacle& other, ObstacleIndex index);
  void add_outline(const Obstacle& obstacle, const Body& body, const Obstacle& other, ObstacleIndex index);
  void add_bounds(const Obstacle& obstacle, const Body& body, const Bounds& bounds);
  template <class IsCovered>
  void add_cuts(const Body& body, ObstacleIndex index, const IsCovered& is_covered);

  std::vector<Range> ranges_;  ///< by obstacle
  std::vector<Cut> cuts_;
  std::vector<ObstacleIndex> brushes_;
  std::vector<ObstacleIndex> near_;  ///< scratch
  std::vector<Vec2> points_;         ///< scratch
  std::vector<double> orders_;       ///< scratch
};

}  // namespace regista::graph
