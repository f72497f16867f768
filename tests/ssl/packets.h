// Packets in protobuf's text format, as several tests send them.
#pragma once

#include <string>

namespace regista {

inline std::string detection_text(int camera, int frame_number) {
  return "detection { frame_number: " + std::to_string(frame_number) + " camera_id: " + std::to_string(camera) + R"(
    t_capture: 1700000000.25 t_sent: 1700000000.3
    balls { confidence: 0.75 area: 60 x: -1500 y: 2250.5 z: 0 pixel_x: 10 pixel_y: 20 }
    robots_yellow { confidence: 0.5 robot_id: 3 x: 1000 y: -2000 orientation: 1.5 pixel_x: 1 pixel_y: 2 height: 150 }
    robots_blue { confidence: 1 robot_id: 12 x: -5999 y: 4499 orientation: -3 pixel_x: 1 pixel_y: 2 }
  } source: SSL_SOURCE_SSL_VISION)";
}

inline std::string geometry_text(int length_mm = 12000, int width_mm = 9000) {
  return " geometry { field { field_length: " + std::to_string(length_mm) +
         " field_width: " + std::to_string(width_mm) +
         R"( goal_width: 1800 goal_depth: 180 boundary_width: 300 boundary_width_goal_line: 600
      field_lines { name: "TopTouchLine" p1 { x: -6000 y: 4500 } p2 { x: 6000 y: 4500 } thickness: 10 type: TopTouchLine }
      field_arcs { name: "CenterCircle" center { x: 0 y: 0 } radius: 500 a1: 0 a2: 6.283 thickness: 10 type: CenterCircle }
      penalty_area_depth: 1800 penalty_area_width: 3600 }
    calib { camera_id: 1 focal_length: 500 principal_point_x: 390 principal_point_y: 290 distortion: 0.1
      q0: 0.7 q1: -0.7 q2: 0 q3: 0 tx: 10 ty: 1000 tz: 3500 }
    models { straight_two_phase { acc_slide: -3.9 acc_roll: -0.35 k_switch: 0.69 } } })";
}

inline std::string referee_text(const std::string& command, const std::string& more = "") {
  return R"(packet_timestamp: 1700000000250000 stage: NORMAL_SECOND_HALF command_counter: 77
    command_timestamp: 1700000000000000
    yellow { name: "one" score: 1 red_cards: 0 yellow_cards: 2 yellow_card_times: [ 5, 7 ] timeouts: 4
      timeout_time: 300 goalkeeper: 3 }
    blue { name: "two" score: 4 red_cards: 1 yellow_cards: 0 timeouts: 4 timeout_time: 300 goalkeeper: 15 }
    command: )" +
         command + " " + more;
}

}  // namespace regista
