// The wheels of a whole team: one geometry for all robots, and exceptions by number for those that were built
// otherwise.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "control/wheels.h"

namespace regista {

class TeamWheels {
 public:
  /// Exceptions are text, "3: hub_radius_m=0.07 wheel_radius_m=0.03; 12: bearings_rad=0.9,2.3,-2.3,-0.9": robot number,
  /// then fields of WheelGeometry that replace the common ones. Throws std::invalid_argument, with the part in the
  /// text, where that cannot be read, a field is out of its range, a robot comes twice, or some wheels make no robot.
  TeamWheels(const WheelGeometry& common, const std::string& exceptions);

  const OmniWheels& of(std::uint16_t robot) const;

 private:
  OmniWheels common_;
  std::map<std::uint16_t, OmniWheels> exceptions_;  // by robot number
};

}  // namespace regista
