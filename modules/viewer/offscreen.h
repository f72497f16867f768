// One picture of a scene, drawn without a display.
#pragma once

#include <span>
#include <stdexcept>
#include <string>

#include "modules/viewer/viewer_scene.h"

namespace regista {

struct PictureError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes a PNG of width x height pixels, each at least 1; fitted_view() tells where a field point comes to lie.
/// Throws PictureError with one line when there is no renderer or the file cannot be written.
void write_picture(const ViewerScene& scene, const std::string& file, int width_px, int height_px);

/// The same of several scenes, at least one, in rows of at most three from left to right; each takes that many pixels.
void write_strip(std::span<const ViewerScene> scenes, const std::string& file, int width_px, int height_px);

}  // namespace regista
