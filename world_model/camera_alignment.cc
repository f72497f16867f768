#include "world_model/camera_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace regista {

Vec2 CameraAlignment::shift_m(std::uint32_t camera) const {
  const Eigen::Index row = row_of(camera);
  return row < shifts_m_.rows() ? Vec2(shifts_m_.row(row)) : Vec2::Zero();
}

Eigen::Index CameraAlignment::row_of(std::uint32_t camera) const {
  return std::find(cameras_.begin(), cameras_.end(), camera) - cameras_.begin();
}

void CameraAlignment::compare(std::uint32_t first, const Vec2& first_m, std::uint32_t second, const Vec2& second_m,
                              const CameraAlignmentParams& params) {
  for (const std::uint32_t camera : {first, second}) {
    if (row_of(camera) == static_cast<Eigen::Index>(cameras_.size())) cameras_.push_back(camera);
  }
  Difference& difference = differences_[std::minmax(first, second)];
  const Vec2 seen_m = first < second ? Vec2(second_m - first_m) : Vec2(first_m - second_m);
  difference.pairs = std::min(difference.pairs + 1.0, params.memory_pairs);
  difference.mean_m += (seen_m - difference.mean_m) / difference.pairs;
  solve(params);
}

/// Normal equations of Σ pairs |s_b − s_a − mean_ab|² / pair_sigma² + Σ |s_c|² / shift_sigma², times pair_sigma².
void CameraAlignment::solve(const CameraAlignmentParams& params) {
  const auto cameras = static_cast<Eigen::Index>(cameras_.size());
  const double ratio = params.pair_sigma_m / params.shift_sigma_m;
  Eigen::MatrixXd normal = ratio * ratio * Eigen::MatrixXd::Identity(cameras, cameras);
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(cameras, 2);
  for (const auto& [pair, difference] : differences_) {
    const Eigen::Index a = row_of(pair.first);
    const Eigen::Index b = row_of(pair.second);
    normal(a, a) += difference.pairs;
    normal(b, b) += difference.pairs;
    normal(a, b) -= difference.pairs;
    normal(b, a) -= difference.pairs;
    right.row(a) -= difference.pairs * difference.mean_m.transpose();
    right.row(b) += difference.pairs * difference.mean_m.transpose();
  }
  shifts_m_ = normal.llt().solve(right);
}

}  // namespace regista
