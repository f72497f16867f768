// Which part of the field a camera sees: cameras share it in columns (four of them in two rows of two), and neighbours
// overlap.
#pragma once

#include <limits>

#include "sim/sim_params.h"
#include "world_model/types/field.h"

namespace regista {

/// Borders included; at the field's edge a view has no end. Metres.
struct CameraView {
  Vec2 low_m = Vec2::Constant(-std::numeric_limits<double>::infinity());
  Vec2 high_m = Vec2::Constant(std::numeric_limits<double>::infinity());
  bool operator==(const CameraView&) const = default;
};

inline bool sees(const CameraView& view, const Vec2& place_m) {
  return (place_m.array() >= view.low_m.array()).all() && (place_m.array() <= view.high_m.array()).all();
}

/// The view of camera number `camera` < params.cameras.
CameraView camera_view(const FieldGeometry& field, std::uint32_t camera, const VisionParams& params);

}  // namespace regista
