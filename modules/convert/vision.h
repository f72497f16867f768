// VISION and GEOMETRY: vision_frame_t and field_geometry_t.
#pragma once

#include "modules/bus/service_values.h"
#include "modules/convert/message.h"
#include "regista/field_geometry_t.hpp"
#include "regista/vision_frame_t.hpp"
#include "world_model/types/vision_frame.h"

namespace regista {

template <>
struct MessageOf<VisionFrame> {
  using Message = vision_frame_t;
  static constexpr std::array<std::size_t, 2> kElementBytes{35, 24};
  static Message to_message(const VisionFrame& frame);
  static VisionFrame from_message(const Message& message);
};

template <>
struct MessageOf<FieldAnnouncement> {
  using Message = field_geometry_t;
  static constexpr std::array<std::size_t, 0> kElementBytes{};
  static Message to_message(const FieldAnnouncement& announcement);
  static FieldAnnouncement from_message(const Message& message);
};

}  // namespace regista
