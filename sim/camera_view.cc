#include "sim/camera_view.h"

namespace regista {
namespace {

/// Cuts one axis of the field into equal parts and grows the inner borders of the given one by half the overlap.
void set_axis(CameraView& view, int axis, double length_m, std::uint32_t part, std::uint32_t parts, double overlap_m) {
  const double part_m = length_m / parts;
  if (part > 0) view.low_m[axis] = -length_m / 2.0 + part * part_m - overlap_m / 2.0;
  if (part + 1 < parts) view.high_m[axis] = -length_m / 2.0 + (part + 1) * part_m + overlap_m / 2.0;
}

}  // namespace

CameraView camera_view(const FieldGeometry& field, std::uint32_t camera, const VisionParams& params) {
  const auto cameras = static_cast<std::uint32_t>(params.cameras);
  const std::uint32_t rows = cameras % 2 == 0 && cameras > 2 ? 2 : 1;
  const std::uint32_t columns = cameras / rows;
  CameraView view;
  set_axis(view, 0, field.length_m, camera % columns, columns, params.camera_overlap_m);
  set_axis(view, 1, field.width_m, camera / columns, rows, params.camera_overlap_m);
  return view;
}

}  // namespace regista
