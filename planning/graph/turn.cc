#include "planning/graph/turn.h"

#include <array>

namespace regista::graph {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTanPi8 = std::numbers::sqrt2 - 1.0;

/// atan(x)/x as a polynomial in x² for |x| <= tan(π/8): Chebyshev fit, error of the angle below 5e-16.
constexpr std::array kAtan{0.9999999999999991,  -0.3333333333322457,  0.19999999978876792, -0.14285712690506924,
                           0.11111049714041536, -0.09089544390331752, 0.07673677753974685, -0.06506801232421022,
                           0.0502729986098597,  -0.02534928220990764};

/// Estrin's scheme: a product waits for few before it.
double small_atan(double x) {
  const double z = x * x;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const auto pair = [z](std::size_t i) { return kAtan[i] + kAtan[i + 1] * z; };
  const double low = (pair(0) + pair(2) * z2) + (pair(4) + pair(6) * z2) * z4;
  return (low + pair(8) * (z4 * z4)) * x;
}

}  // namespace

double turn(const Vec2& from, const Vec2& to, double side) {
  const double sine = side * cross(from, to);
  const double cosine = from.dot(to);
  const double less = std::min(std::abs(sine), std::abs(cosine));
  const double more = std::max(std::abs(sine), std::abs(cosine));
  // Either as it is, or against the diagonal.
  const bool is_steep = less > kTanPi8 * more;
  const double x = is_steep ? (less - more) / (less + more) : less / more;
  double angle_rad = small_atan(x) + (is_steep ? kPi / 4 : 0.0);
  if (std::abs(sine) > std::abs(cosine)) angle_rad = kPi / 2 - angle_rad;
  if (cosine < 0.0) angle_rad = kPi - angle_rad;
  if (sine >= 0.0) return angle_rad;
  return angle_rad <= kNoTurn_rad ? 0.0 : 2.0 * kPi - angle_rad;
}

}  // namespace regista::graph
