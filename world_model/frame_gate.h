// Decides by its stamps whether a vision frame may enter the world model: time never runs backwards nor, for a stray
// stamp, ahead; no moment of a camera counts twice; and a source whose clock was set anew (a simulator that restarted)
// is followed instead of ignored for ever.
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
  refused,    ///< its time jumps, and the next frames will tell whether it is true; or its camera's clock stands still
};

/// How many frames had which result.
struct FrameCounts {
  std::int64_t taken = 0;
  std::int64_t restarted = 0;
  std::int64_t duplicate = 0;
  std::int64_t late = 0;
  std::int64_t refused = 0;
  bool operator==(const FrameCounts&) const = default;
};

const char* name(FrameResult result);

struct FrameGateParams {
  double late_s = 0.05;  // cameras at 60 Hz and their transport differ by less
  double ahead_s = 0.1;  // five frames of 50 Hz
  double clock_back_s = 1.0;
  double clock_forward_s = 5.0;  // first packets of a simulator may carry times far in the future
  std::int64_t jump_frames = 3;  // a stray stamp or two in a row move nothing; a true jump costs 30 ms
  bool operator==(const FrameGateParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("late_s", self.late_s, Range{0.0, 1.0}, "s", "frames older than the newest by more are not used");
    v("ahead_s", self.ahead_s, Range{0.001, 10.0}, "s",
      "frames ahead of the newest by more must be confirmed, unless the source is that slow");
    v("clock_back_s", self.clock_back_s, Range{0.1, 3600.0}, "s", "older by more: the source's clock was set back");
    v("clock_forward_s", self.clock_forward_s, Range{0.1, 1e6}, "s", "newer by more: the source's clock was set ahead");
    v("jump_frames", self.jump_frames, Range{1.0, 1000.0}, "", "frames in a row that must agree on a jump in time");
  }
};

class FrameGate {
 public:
  /// Judges the frame by its stamps and, where the result is taken or restarted, counts it as seen. After a silence
  /// (more than ahead_s without a frame) jump_frames frames in a row within clock_back_s of each other show that it was
  /// one; the last of them is taken. So a source slower than a frame per clock_back_s is not followed.
  FrameResult judge(const VisionFrame& frame, const FrameGateParams& params);

  /// Capture time of the newest frame taken; none before the first.
  std::optional<Time> newest() const { return newest_; }

  /// Of all frames judged so far.
  const FrameCounts& counts() const { return counts_; }

 private:
  struct Seen {
    std::uint32_t camera = 0;
    std::uint32_t frame_number = 0;
    Time captured{};
  };

  FrameResult judge_stamps(const VisionFrame& frame, const FrameGateParams& params);
  FrameResult judge_jump(const VisionFrame& frame, bool clock_set, const FrameGateParams& params);
  void follow_spacing(double step_s);
  void remember(const VisionFrame& frame, const FrameGateParams& params);

  std::optional<Time> newest_;
  FrameCounts counts_;
  std::vector<Seen> seen_;   // all that could come again without being late; each moment of a camera once
  std::int64_t jumped_ = 0;  // frames in a row
  Time jumped_to_{};         // capture time of the last of them
  double spacing_s_ = 0.0;   // usual time between frames of a slow source; less than it for others
};

}  // namespace regista
