#include "modules/bench/motion/loop_recorder.h"

#include "modules/bus/channels.h"
#include "modules/convert/codec.h"

namespace regista::bench {

LoopRecorder::LoopRecorder(const std::string& file, const FieldGeometry& field) : field_(field), writer_(file) {}

void LoopRecorder::record(const ClosedLoop& loop) {
  const Time now = loop.simulator().now();
  if (!announced_) {
    writer_.write(now, channels::geometry().name, encode(FieldAnnouncement{now, field_}));
    announced_ = true;
  }
  // The viewer matches plans and world by the capture's stamp and sequence.
  WorldState shown = loop.truth();
  shown.captured = loop.world().captured;
  shown.sequence = loop.world().sequence;
  writer_.write(now, channels::world_state().name, encode(shown));
  for (const Team team : {Team::yellow, Team::blue}) {
    if (loop.driver(team) == nullptr) continue;
    writer_.write(now, channels::targets(team).name, encode(loop.targets(team)));
    for (const RobotPlan& plan : loop.driver(team)->plans()) {
      writer_.write(now, channels::plan(plan.robot).name, encode(plan));
    }
  }
}

}  // namespace regista::bench
