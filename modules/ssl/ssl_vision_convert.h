// SSL-Vision's detections as our vision frames: millimetres to metres, seconds to stamps, what has no identity left
// out. Messages: SSL-Vision, as in proto/ssl_vision_detection.proto.
#pragma once

#include <cstdint>

#include "world_model/types/vision_frame.h"

class SSL_DetectionFrame;

namespace regista {

struct ConvertedFrame {
  VisionFrame frame;
  std::int64_t robots_skipped = 0;  ///< seen without number or heading, or with a number beyond 65535
};

/// Stamps stay on the source's own clock, which may be Unix time or count from the source's start: all deadlines are
/// measured from arrival, so no mapping to the local clock is made. Confidences are clamped to 0–1, since sources scale
/// them as they like. Throws MessageError where a value is not finite, farther than 1 km or past 10¹¹ s.
ConvertedFrame to_vision_frame(const SSL_DetectionFrame& detection);

}  // namespace regista
