// SSL-Vision's geometry as our field: millimetres to metres, gaps filled from the drawn lines or the division's rules.
// Messages: SSL-Vision, as in proto/ssl_vision_geometry.proto.
#pragma once

#include "world_model/types/field.h"

class SSL_GeometryData;

namespace regista {

/// The defence areas are the announced ones, else those of the drawn lines, else of the division whose length is
/// nearer; likewise the centre circle. The vision does not know which team defends which goal: that is an argument.
/// Throws MessageError where a length is negative, the field smaller than 0.1 m or larger than 1 km, or a defence area
/// does not fit its half.
FieldGeometry to_field_geometry(const SSL_GeometryData& geometry, bool yellow_on_positive_x);

}  // namespace regista
