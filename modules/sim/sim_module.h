// The field's stand-in on the bus: COMMANDS in, VISION, GEOMETRY and TRUTH out.
#pragma once

#include <utility>
#include <vector>

#include "modules/bus/module.h"
#include "sim/simulator.h"

namespace regista {

class SimModule : public Module {
 public:
  /// Throws std::invalid_argument when the setup makes no sense; its start must not lie after the bus's present time.
  SimModule(Bus& bus, const SimSetup& setup);
  std::optional<Time> due() const override { return simulator_.next_frame_due(); }

  /// For scoring only.
  const Simulator& simulator() const { return simulator_; }

 protected:
  bool has_input() const override { return false; }
  void on_tick(Time now) override;

 private:
  void listen(Team team, TeamCommands commands);
  void announce_geometry(Time now);
  std::string teleport(const Request& request);

  FieldGeometry field_;
  Simulator simulator_;
  std::vector<std::pair<Time, TeamCommands>> commands_;  ///< since the last tick, with their arrival
  Listener<TeamCommands> yellow_commands_;
  Listener<TeamCommands> blue_commands_;
  std::optional<Time> geometry_sent_;
};

}  // namespace regista
