// Do these opponents and we run into each other? Whose fault it is is not asked. Who avoids nobody shows it soon, and
// then it pays to drive so that a crash is theirs. Among opponents that keep clear, as most do, the same care would
// only cost pace.
#pragma once

#include <set>
#include <utility>

#include "world_model/params.h"
#include "world_model/types/world_state.h"

namespace regista {

struct RoughPlayParams {
  /// Opponents count as rough from so many contacts within about the memory. Random drivers at 2 m/s that avoid nobody
  /// make two with a team of 11 on 9 × 6 m, chasers at 3 m/s eighteen. 0: always.
  double contacts = 6.0;
  double memory_s = 30.0;  ///< time constant with which contacts are forgotten
  double touch_m = 0.005;  ///< bodies nearer than this touch: noise of vision
  bool operator==(const RoughPlayParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("contacts", self.contacts, Range{0.0, 1e6}, "", "opponents are rough from so many contacts on; 0: always");
    v("memory_s", self.memory_s, Range{0.1, 1e6}, "s", "time constant with which contacts are forgotten");
    v("touch_m", self.touch_m, Range{0.0, 0.1}, "m", "bodies nearer than this touch");
  }
};

class RoughPlay {
 public:
  /// Looks at the world, dt_s > 0 after the last look. `radius_m`: of all robots.
  void update(const WorldState& world, Team ours, double dt_s, double radius_m, const RoughPlayParams& params);

  /// Contacts, the older the less they count.
  double contacts() const { return contacts_; }
  bool is_rough(const RoughPlayParams& params) const { return contacts_ >= params.contacts; }

 private:
  std::set<std::pair<RobotId, RobotId>> touching_;
  double contacts_ = 0.0;
};

}  // namespace regista
