// A KD-tree of points in the plane that grows point by point. The only file that sees nanoflann.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// GCC 12 sees the copies of empty trees in nanoflann's constructor and takes their boxes for used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <nanoflann.hpp>
#pragma GCC diagnostic pop

#include "world_model/types/geometry.h"

namespace regista {

class KdTree {
 public:
  /// At most `points_max` points will be added. Leaves hold up to leaf_size points.
  explicit KdTree(std::size_t points_max, std::size_t leaf_size = 5)
      : tree_(2, points_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size), std::max<std::size_t>(points_max, 2)) {}
  KdTree(const KdTree&) = delete;
  KdTree& operator=(const KdTree&) = delete;

  std::size_t size() const { return points_.values.size(); }
  const Vec2& operator[](std::size_t index) const { return points_.values[index]; }

  void add(const Vec2& point) {
    points_.values.push_back(point);
    tree_.addPoints(size() - 1, size() - 1);
  }

  struct Nearest {
    std::size_t index = 0;
    double distance_m = std::numeric_limits<double>::infinity();  ///< infinity while the tree is empty
  };

  Nearest nearest(const Vec2& point) const {
    if (points_.values.empty()) return {};
    Nearest found;
    nanoflann::KNNResultSet<double> result(1);
    double distance2 = 0.0;
    result.init(&found.index, &distance2);
    tree_.findNeighbors(result, point.data(), nanoflann::SearchParams());
    found.distance_m = std::sqrt(distance2);
    return found;
  }

 private:
  /// The interface nanoflann asks for its data.
  struct Points {
    std::vector<Vec2> values;
    std::size_t kdtree_get_point_count() const { return values.size(); }
    double kdtree_get_pt(std::size_t index, std::size_t axis) const {
      return values[index][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  using Tree =
      nanoflann::KDTreeSingleIndexDynamicAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 2, std::size_t>;

  Points points_;
  Tree tree_;
};

}  // namespace regista
