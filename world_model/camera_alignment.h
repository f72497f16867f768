// How far each camera's picture lies beside those of the others, learnt while the game runs from robots that two
// cameras see: calibrations differ by up to 20 mm in the league, and a robot that changed cameras would seem to jump.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "world_model/params.h"
#include "world_model/types/geometry.h"

namespace regista {

struct CameraAlignmentParams {
  bool learn = true;
  double pair_within_s = 0.03;   // two frames of 60 Hz cameras lie nearer than this; motion in between is small
  double pair_sigma_m = 0.002;   // of the difference of two sights: 1.3 mm each, and a little for the motion
  double shift_sigma_m = 0.01;   // of a camera's shift, per axis: up to 20 mm
  double memory_pairs = 3000.0;  // ten robots in an overlap for three seconds: cameras get knocked, lenses warm up
  bool operator==(const CameraAlignmentParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("learn", self.learn, Range{0.0, 1.0}, "", "learn how far cameras are shifted against each other");
    v("pair_within_s", self.pair_within_s, Range{0.0, 1.0}, "s",
      "two cameras' sights of a robot this near are compared");
    v("pair_sigma_m", self.pair_sigma_m, Range{1e-6, 1.0}, "m", "noise of such a comparison, per axis");
    v("shift_sigma_m", self.shift_sigma_m, Range{1e-6, 1.0}, "m", "how far cameras are expected to be off, per axis");
    v("memory_pairs", self.memory_pairs, Range{1.0, 1e9}, "", "comparisons after which old ones count little");
  }
};

class CameraAlignment {
 public:
  /// What to take off from a place that camera sees; zero for a camera that was never compared.
  Vec2 shift_m(std::uint32_t camera) const;

  /// One thing was seen by two different cameras, the first sight already moved on to the moment of the second. The
  /// shifts become those that explain all comparisons best: least squares over the means per pair of cameras, each
  /// camera expected at no shift with shift_sigma_m. What all cameras have in common cannot be seen: the shifts of
  /// cameras that are linked by comparisons add up to zero.
  void compare(std::uint32_t first, const Vec2& first_m, std::uint32_t second, const Vec2& second_m,
               const CameraAlignmentParams& params);

 private:
  struct Difference {
    Vec2 mean_m = Vec2::Zero();  // second minus first
    double pairs = 0.0;          // in it, as far as remembered
  };
  void solve(const CameraAlignmentParams& params);
  Eigen::Index row_of(std::uint32_t camera) const;

  std::vector<std::uint32_t> cameras_;                                         // compared so far
  Eigen::MatrixX2d shifts_m_;                                                  // a row per camera
  std::map<std::pair<std::uint32_t, std::uint32_t>, Difference> differences_;  // smaller camera number first
};

}  // namespace regista
