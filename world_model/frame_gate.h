// Decides by its stamps whether a vision frame may enter the world model: time never runs backwards, no frame counts
// twice, and a source whose clock was set anew (a simulator that restarted) is followed instead of ignored for ever.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world_model/params.h"
#include "world_model/types/vision_frame.h"

namespace regista {

enum class FrameResult : std::uint8_t {
  taken,      ///< in the estimate
  restarted,  ///< taken, after everything known was forgotten because the source's clock jumped
  duplicate,  ///< same camera, frame number and capture time as one taken before
  late,       ///< too old beside the newest frame
  refused,    ///< its time jumps; the next frames will tell whether the clock was set anew
};

const char* name(FrameResult result);

struct FrameGateParams {
  double late_s = 0.05;  // cameras at 60 Hz and their transport differ by less
  double clock_back_s = 1.0;
  double clock_forward_s = 5.0;  // first packets of a simulator may carry times far in the future
  std::int64_t jump_frames = 3;  // one stray stamp resets nothing; a restart costs 30 ms
  bool operator==(const FrameGateParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("late_s", self.late_s, Range{0.0, 1.0}, "s", "frames older than the newest by more are not used");
    v("clock_back_s", self.clock_back_s, Range{0.1, 3600.0}, "s", "older by more: the source's clock was set back");
    v("clock_forward_s", self.clock_forward_s, Range{0.1, 1e6}, "s", "newer by more: the source's clock was set ahead");
    v("jump_frames", self.jump_frames, Range{1.0, 1000.0}, "",
      "frames in a row that must agree on a jump of the clock");
  }
};

class FrameGate {
 public:
  /// Judges the frame by its stamps and, where the result is taken or restarted, counts it as seen.
  FrameResult judge(const VisionFrame& frame, const FrameGateParams& params);

  /// Capture time of the newest frame taken; none before the first.
  std::optional<Time> newest() const { return newest_; }

 private:
  struct Seen {
    std::uint32_t camera = 0;
    std::uint32_t frame_number = 0;
    Time captured{};
  };

  bool jump_confirmed(Time captured, const FrameGateParams& params);
  void remember(const VisionFrame& frame, const FrameGateParams& params);

  std::optional<Time> newest_;
  std::vector<Seen> seen_;   // all that could come again without being late
  std::int64_t jumped_ = 0;  // frames in a row
  Time jumped_to_{};         // capture time of the last of them
};

}  // namespace regista
