// VISION and COMMANDS in, WORLD_STATE out: one state per tick, made from all frames that have come in.
#pragma once

#include "modules/bus/module.h"
#include "modules/process/real_clock.h"
#include "world_model/world_model.h"

namespace regista {

class WorldModelModule : public Module {
 public:
  WorldModelModule(Bus& bus, const WorldModelParams& params, Stopwatch stopwatch);
  std::string note() const override;

 protected:
  bool has_input() const override { return !frames_.empty(); }
  void on_tick(Time now) override;

 private:
  void take_commands(Queue<TeamCommands>& queue);

  WorldModelParams params_;
  WorldModel model_;
  Stopwatch stopwatch_;
  Queue<VisionFrame> frames_;
  Queue<TeamCommands> yellow_commands_;
  Queue<TeamCommands> blue_commands_;
  bool seen_ = false;
};

}  // namespace regista
