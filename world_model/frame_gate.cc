#include "world_model/frame_gate.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

/// Ten times what eight cameras of 100 Hz send while a frame is not late (0.05 s): bounds what odd stamps can cost.
constexpr std::size_t kSeenMax = 400;

/// A frame this many usual spacings ahead is no jump: two frames in between were lost.
constexpr double kSpacings = 3.0;

/// Per frame, how much shorter the usual spacing may become: bursts of several slow cameras do not make a fast source.
constexpr double kSpacingKept = 0.95;

std::int64_t& count_of(FrameCounts& counts, FrameResult result) {
  switch (result) {
    case FrameResult::taken:
      return counts.taken;
    case FrameResult::restarted:
      return counts.restarted;
    case FrameResult::duplicate:
      return counts.duplicate;
    case FrameResult::late:
      return counts.late;
    case FrameResult::refused:
      break;
  }
  return counts.refused;
}

}  // namespace

const char* name(FrameResult result) {
  switch (result) {
    case FrameResult::taken:
      return "taken";
    case FrameResult::restarted:
      return "restarted";
    case FrameResult::duplicate:
      return "duplicate";
    case FrameResult::late:
      return "late";
    case FrameResult::refused:
      return "refused";
  }
  return "unknown";
}

FrameResult FrameGate::judge(const VisionFrame& frame, const FrameGateParams& params) {
  const FrameResult result = judge_stamps(frame, params);
  ++count_of(counts_, result);
  return result;
}

FrameResult FrameGate::judge_stamps(const VisionFrame& frame, const FrameGateParams& params) {
  if (newest_) {
    const double ahead_s = to_seconds(frame.captured - *newest_);
    const bool clock_set = ahead_s < -params.clock_back_s || ahead_s > params.clock_forward_s;
    if (clock_set || ahead_s > std::max(params.ahead_s, kSpacings * spacing_s_)) {
      return judge_jump(frame, clock_set, params);
    }
    const auto same = std::find_if(seen_.begin(), seen_.end(), [&](const Seen& seen) {
      return seen.camera == frame.camera && seen.captured == frame.captured;
    });
    if (same != seen_.end()) {
      return same->frame_number == frame.frame_number ? FrameResult::duplicate : FrameResult::refused;
    }
    if (ahead_s < -params.late_s) return FrameResult::late;
    follow_spacing(ahead_s);
  }
  jumped_ = 0;
  remember(frame, params);
  return FrameResult::taken;
}

/// A jump is true when enough frames in a row agree on it. A clock set anew starts everything again; a jump ahead by
/// less was a silence.
FrameResult FrameGate::judge_jump(const VisionFrame& frame, bool clock_set, const FrameGateParams& params) {
  const double step_s = std::abs(to_seconds(frame.captured - jumped_to_));
  if (jumped_ > 0 && step_s == 0.0) return FrameResult::refused;  // the same again, or another camera's: says nothing
  jumped_ = jumped_ > 0 && step_s <= params.clock_back_s ? jumped_ + 1 : 1;
  jumped_to_ = frame.captured;
  if (jumped_ < params.jump_frames) return FrameResult::refused;
  if (jumped_ > 1) spacing_s_ = step_s;
  if (clock_set) {
    newest_.reset();
    seen_.clear();
  }
  jumped_ = 0;
  remember(frame, params);
  return clock_set ? FrameResult::restarted : FrameResult::taken;
}

/// Only confirmed jumps lengthen the usual spacing by more than double: one stray stamp does not let the next one in.
void FrameGate::follow_spacing(double step_s) {
  if (step_s <= 0.0) return;
  spacing_s_ = std::max(kSpacingKept * spacing_s_, step_s <= 2.0 * spacing_s_ ? step_s : 0.0);
}

void FrameGate::remember(const VisionFrame& frame, const FrameGateParams& params) {
  newest_ = newest_ ? std::max(*newest_, frame.captured) : frame.captured;
  const Time oldest = *newest_ - from_seconds(params.late_s);
  std::erase_if(seen_, [&](const Seen& seen) { return seen.captured < oldest; });
  if (seen_.size() >= kSeenMax) seen_.erase(seen_.begin());
  seen_.push_back({frame.camera, frame.frame_number, frame.captured});
}

}  // namespace regista
