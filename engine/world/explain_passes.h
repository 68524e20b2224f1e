// What the passes of smooth motion read, write and cost.
#pragma once

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

enum class StepPath { implicit, fused, staged };

/// How a world takes its steps.
struct StepPlan {
  StepPath path;
  bool iterates;              ///< are stages found by fixed-point iteration?
  int calls;                  ///< phases that are evaluated in a step
  const std::string& reason;  ///< of the path
};

/// Adds the group's passes in the order of a step.
void explain_passes(const Group& group, const Method& method, const StepPlan& plan, const Columns& columns,
                    std::vector<PassReport>& passes);

}  // namespace ballpark::BALLPARK_PRECISION
