// The points a path may turn at around one obstacle: the paper's samples. Pure functions of the field, so that every
// robot of a team sees the same points.
#pragma once

#include <vector>

#include "planning/obstacle_field.h"

namespace regista::graph {

/// Farther than this from its nearest neighbour an obstacle gets few samples (visibility-sampling paper: "four points
/// … when it's far away (>1000mm) and six points … when it's near"). Measured here between boundaries, since the gap is
/// what a path has to fit through.
inline constexpr double kNear_m = 1.0;
inline constexpr int kSamplesFar = 4;
/// The paper says six in its text and eight in its example; eight is symmetric in x and in y.
inline constexpr int kSamplesNear = 8;

/// No obstacle has more.
inline constexpr std::size_t kSamplesMax = std::size_t{2} * kSamplesNear;

/// An upper bound of the number of samples of an obstacle of this kind.
std::size_t samples_max(const Obstacle& obstacle);

/// What is farther than this from an obstacle of the radius neither makes its samples dense nor covers one. Metres.
double samples_reach_m(double radius_m);

/// Appends the samples of obstacle `index` of the field that lie within the bounds, in a fixed order:
/// - disc: points on a circle of radius r/cos(π/n), so that neighbours just see each other past the disc; n depends on
///   the distance to the nearest other obstacle of the field;
/// - capsule: the samples of its two end circles, points inside the capsule dropped;
/// - rectangle: the four corners of the grown rectangle.
/// Other obstacles may cover them. `neighbours`: at least those others that are within samples_reach_m().
void append_samples(const ObstacleField& field, ObstacleIndex index, std::span<const ObstacleIndex> neighbours,
                    std::vector<Vec2>& out);

/// The same for one who does not know the neighbours.
void append_samples(const ObstacleField& field, ObstacleIndex index, std::vector<Vec2>& out);

/// Least distance between two obstacles' boundaries, metres; negative when they overlap.
double gap(const Obstacle& one, const Obstacle& other);

}  // namespace regista::graph
