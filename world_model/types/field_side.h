// Which team defends which goal.
#pragma once

#include "world_model/types/field.h"
#include "world_model/types/robot_id.h"

namespace regista {

/// True when that team's goal is the one on the -x side.
constexpr bool defends_negative_x(Team team, const FieldGeometry& field) {
  return (team == Team::yellow) != field.yellow_on_positive_x;
}

}  // namespace regista
