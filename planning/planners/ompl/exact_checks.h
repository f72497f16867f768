// The field as OMPL asks for it: states and motions are tested by the field itself, exactly, never stepped along.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "planning/planner.h"

namespace regista {

inline Vec2 point_of(const ompl::base::State* state) {
  const double* values = state->as<ompl::base::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

inline void set_point(ompl::base::State* state, const Vec2& point) {
  double* values = state->as<ompl::base::RealVectorStateSpace::StateType>()->values;
  values[0] = point.x();
  values[1] = point.y();
}

class ExactStates : public ompl::base::StateValidityChecker {
 public:
  ExactStates(const ompl::base::SpaceInformationPtr& information, const ObstacleField& field, const Query& query)
      : StateValidityChecker(information), field_(field), query_(query) {}

  bool isValid(const ompl::base::State* state) const override {
    return field_.is_free(point_of(state), query_.ignored);
  }

 private:
  const ObstacleField& field_;
  const Query& query_;
};

class ExactMotions : public ompl::base::MotionValidator {
 public:
  ExactMotions(const ompl::base::SpaceInformationPtr& information, const ObstacleField& field, const Query& query)
      : MotionValidator(information), field_(field), query_(query) {}

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override {
    return field_.is_free(point_of(from), point_of(to), query_.ignored);
  }

  /// A blocked motion is given up from its beginning.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    if (last_valid.first != nullptr) set_point(last_valid.first, point_of(from));
    last_valid.second = 0.0;
    return false;
  }

 private:
  const ObstacleField& field_;
  const Query& query_;
};

}  // namespace regista
