// What a ViewerScene looks like: shapes on the field and lines of text. No OpenGL.
#pragma once

#include <string>
#include <vector>

#include "modules/viewer/drawing.h"
#include "modules/viewer/viewer_scene.h"

namespace regista {

namespace palette {
constexpr Color kSurroundings{23, 27, 31};
constexpr Color kStrip{27, 62, 40};
constexpr Color kGrass{36, 82, 52};
constexpr Color kGrassBand{39, 87, 55};
constexpr Color kFieldLine{215, 225, 218};
constexpr Color kYellow{255, 212, 24};
constexpr Color kBlue{64, 140, 255};
constexpr Color kBall{255, 120, 20};
constexpr Color kInk{14, 18, 22};
constexpr Color kWhite{255, 255, 255};
constexpr Color kWarning{230, 70, 60};
}  // namespace palette

constexpr Color color_of(Team team) { return team == Team::yellow ? palette::kYellow : palette::kBlue; }

/// The field with its lines and goals.
Drawing draw_field(const FieldGeometry& field);

/// Graphs, targets, paths, robots with their numbers, ball.
Drawing draw_play(const ViewerScene& scene);

struct TextLine {
  std::string text;  ///< ASCII
  Color color;
  bool operator==(const TextLine&) const = default;
};

/// For the picture's upper left corner: one line per team with its planner and planning times.
std::vector<TextLine> team_lines(const ViewerScene& scene);

/// For the upper right corner: time, number of robots; the notice.
std::vector<TextLine> state_lines(const ViewerScene& scene);

}  // namespace regista
