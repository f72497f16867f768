#include "modules/viewer/view.h"

#include <algorithm>

namespace regista {
namespace {

// Shares of the field's height with its strip: two lines of text fit above at 1280 x 800.
constexpr double kTextShare = 0.075;
constexpr double kAirShare = 0.015;

}  // namespace

View fitted_view(const FieldGeometry& field, int width_px, int height_px) {
  const Vec2 half = half_extent(field, 0.0);
  const double air_m = 2 * half.y() * kAirShare;
  const double text_m = 2 * half.y() * kTextShare;
  const double needed_width_m = 2 * (half.x() + air_m);
  const double needed_height_m = 2 * half.y() + air_m + text_m;
  const double m_per_px = std::max(needed_width_m / width_px, needed_height_m / height_px);
  View view;
  view.centre_m = {0.0, (text_m - air_m) / 2};
  view.short_side_m = m_per_px * std::min(width_px, height_px);
  view.width_px = width_px;
  view.height_px = height_px;
  return view;
}

Vec2 pixel_of(const View& view, const Vec2& point_m) {
  const Vec2 offset = (point_m - view.centre_m) * view.pixels_per_m();
  return {view.width_px / 2.0 + offset.x(), view.height_px / 2.0 - offset.y()};
}

}  // namespace regista
