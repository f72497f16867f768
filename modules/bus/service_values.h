// What modules say beside the loop's data: announcements, requests, replies, timing and status.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "world_model/types/field.h"
#include "world_model/types/time.h"

namespace regista {

struct FieldAnnouncement {
  Time sent{};
  FieldGeometry field;
  bool operator==(const FieldAnnouncement&) const = default;
};

/// Repeated by the asker until the reply, acted on once per id.
struct Request {
  Time sent{};
  std::int64_t id = 0;
  std::string module;  ///< addressee, as in ModuleStatus::module
  std::string verb;    ///< "planner.use", "param.set", …
  std::string key;
  std::string value;
  bool operator==(const Request&) const = default;
};

struct Reply {
  Time sent{};
  std::int64_t id = 0;
  bool accepted = false;
  std::string module;
  std::string text;
  bool operator==(const Reply&) const = default;
};

struct RobotTime {
  std::uint16_t robot = 0;
  std::int64_t duration_ns = 0;
  bool operator==(const RobotTime&) const = default;
};

struct Timing {
  Time captured{};
  std::string module;
  std::int64_t tick_ns = 0;
  std::vector<RobotTime> robots;
  bool operator==(const Timing&) const = default;
};

struct ModuleStatus {
  Time sent{};
  std::string module;  ///< "sim", "planner.Y", …
  std::string host;
  std::int32_t pid = 0;
  Duration uptime{};
  double rate_hz = 0.0;          ///< ticks per second over the last second
  std::int64_t tick_p50_ns = 0;  ///< over the last second
  std::int64_t tick_p99_ns = 0;  ///< over the last second
  std::int64_t received = 0;     ///< messages taken since start
  std::int64_t skipped = 0;      ///< messages replaced by newer ones before a tick read them
  std::int64_t refused = 0;      ///< malformed messages
  std::int64_t parameters_fingerprint = 0;
  std::string note;  ///< one line for people
  bool operator==(const ModuleStatus&) const = default;
};

}  // namespace regista
