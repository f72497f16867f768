#include "planning/plan.h"

namespace regista {

const char* name(PlanStatus status) {
  switch (status) {
    case PlanStatus::ok:
      return "ok";
    case PlanStatus::not_found:
      return "not_found";
    case PlanStatus::unreachable:
      return "unreachable";
    case PlanStatus::invalid:
      break;
  }
  return "invalid";
}

}  // namespace regista
