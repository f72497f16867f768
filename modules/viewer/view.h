// Which part of the plane a picture shows: the whole field from above with a strip for text, at any size of picture.
#pragma once

#include "world_model/types/field.h"

namespace regista {

struct View {
  Vec2 centre_m = Vec2::Zero();  ///< field point in the middle of the picture
  double short_side_m = 1.0;     ///< what the picture's shorter side shows
  int width_px = 0;
  int height_px = 0;

  double pixels_per_m() const { return (width_px < height_px ? width_px : height_px) / short_side_m; }
};

/// The field with its boundary strip, room for the text above it, and a little air around.
View fitted_view(const FieldGeometry& field, int width_px, int height_px);

/// Pixel of a field point, x to the right and y down.
Vec2 pixel_of(const View& view, const Vec2& point_m);

}  // namespace regista
