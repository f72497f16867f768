// Sends a scene as the modules would: for tests of what arrives.
#pragma once

#include "modules/bus/bus.h"
#include "modules/viewer/viewer_scene.h"

namespace regista {

/// One message per part that the scene has. A team's two summaries become one timing message whose tick lasts the
/// team's maximum, with robots at the median but one, which lasts the maximum.
void publish_scene(Bus& bus, const ViewerScene& scene);

}  // namespace regista
