// The league's crash rule: who is to blame when two robots of different teams touch.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace regista {

/// Faster closing than this is a crash; SSL rules.
inline constexpr double kCrashSpeed_mps = 1.5;
/// Robots whose speeds towards each other differ by less are both guilty; SSL rules.
inline constexpr double kCrashDifference_mps = 0.3;

/// Who is not faster than this towards the other is never to blame: if it is a crash, the other is faster by the
/// difference that counts.
inline constexpr double kBlamelessSpeed_mps = (kCrashSpeed_mps - kCrashDifference_mps) / 2.0;

enum class Fault : std::uint8_t { none, first, second, both };

/// From the speeds of two robots towards each other, along the line of centres.
inline Fault crash_fault(double first_towards_mps, double second_towards_mps) {
  if (first_towards_mps + second_towards_mps <= kCrashSpeed_mps) return Fault::none;
  if (std::abs(first_towards_mps - second_towards_mps) < kCrashDifference_mps) return Fault::both;
  return first_towards_mps > second_towards_mps ? Fault::first : Fault::second;
}

/// How far the first one's speed towards the other is beyond what makes the crash its foul, its own or shared, m/s;
/// negative where it is no foul of its.
inline double foul_excess(double first_towards_mps, double second_towards_mps) {
  return std::min(first_towards_mps + second_towards_mps - kCrashSpeed_mps,
                  first_towards_mps - second_towards_mps + kCrashDifference_mps);
}

}  // namespace regista
