#include "world_model/frame_gate.h"

#include <algorithm>
#include <cmath>

namespace regista {

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
  if (newest_) {
    const double ahead_s = to_seconds(frame.captured - *newest_);
    if (ahead_s < -params.clock_back_s || ahead_s > params.clock_forward_s) {
      if (!jump_confirmed(frame.captured, params)) return FrameResult::refused;
      *this = FrameGate{};
      remember(frame, params);
      return FrameResult::restarted;
    }
    if (std::any_of(seen_.begin(), seen_.end(), [&](const Seen& seen) {
          return seen.camera == frame.camera && seen.frame_number == frame.frame_number &&
                 seen.captured == frame.captured;
        })) {
      return FrameResult::duplicate;
    }
    if (ahead_s < -params.late_s) return FrameResult::late;
  }
  jumped_ = 0;
  remember(frame, params);
  return FrameResult::taken;
}

bool FrameGate::jump_confirmed(Time captured, const FrameGateParams& params) {
  const double step_s = to_seconds(captured - jumped_to_);
  if (jumped_ > 0 && step_s == 0.0) return false;  // the same frame again, or another camera's: confirms nothing
  const bool agrees = jumped_ > 0 && std::abs(step_s) <= params.clock_back_s;
  jumped_ = agrees ? jumped_ + 1 : 1;
  jumped_to_ = captured;
  return jumped_ >= params.jump_frames;
}

void FrameGate::remember(const VisionFrame& frame, const FrameGateParams& params) {
  newest_ = newest_ ? std::max(*newest_, frame.captured) : frame.captured;
  const Time oldest = *newest_ - from_seconds(params.late_s);
  std::erase_if(seen_, [&](const Seen& seen) { return seen.captured < oldest; });
  seen_.push_back({frame.camera, frame.frame_number, frame.captured});
}

}  // namespace regista
