// TARGETS, PLAN and GRAPH: targets_t, plan_t and graph_t.
#pragma once

#include "modules/convert/message.h"
#include "planning/graph/graph_picture.h"
#include "planning/plan.h"
#include "planning/targets.h"
#include "regista/graph_t.hpp"
#include "regista/plan_t.hpp"
#include "regista/targets_t.hpp"

namespace regista {

template <>
struct MessageOf<Targets> {
  using Message = targets_t;
  static constexpr std::array<std::size_t, 1> kElementBytes{35};
  static Message to_message(const Targets& targets);
  static Targets from_message(const Message& message);
};

template <>
struct MessageOf<RobotPlan> {
  using Message = plan_t;
  static constexpr std::array<std::size_t, 1> kElementBytes{16};
  static Message to_message(const RobotPlan& plan);
  static RobotPlan from_message(const Message& message);
};

template <>
struct MessageOf<GraphPicture> {
  using Message = graph_t;
  static constexpr std::array<std::size_t, 2> kElementBytes{16, 9};
  static Message to_message(const GraphPicture& graph);
  static GraphPicture from_message(const Message& message);
};

}  // namespace regista
