// Wishing for so much speed towards opponents that a crash is no foul of ours, if they gain no more than 0.5 m/s until
// then. What is wished for only: a robot that is faster already, or dodges, may still commit one.
#pragma once

#include <span>

#include "control/safety/opponent.h"

namespace regista {

/// The largest speed towards an opponent gap_m >= 0 away and coming nearer with closing_mps from which braking with
/// braking_mps2 > 0 leads below kBlamelessSpeed_mps before bodies meet, m/s. What it may gain meanwhile is in it.
double blameless_approach(double gap_m, double closing_mps, double braking_mps2);

/// The wanted velocity of a robot there, with less of it towards each opponent (blameless_approach). contact_m: between
/// centres of robots that touch, margin included.
Vec2 careful_approach(const Vec2& wanted_mps, const Vec2& from_m, std::span<const Opponent> opponents, double contact_m,
                      double braking_mps2);

}  // namespace regista
