// Where bodies are at the start: lists, generators and perturbation resolved for one body.
#pragma once

#include "ballpark/scene.h"
#include "engine/world/inertia.h"

namespace ballpark::BALLPARK_PRECISION {

struct Start {
  Vector3<Wide> position, velocity, angular_velocity;  ///< world frame
  Quaternion orientation;
};

/// Body i of group g in a copy with this seed. Depends on nothing else, so copies keep the bits of their solo runs.
Start start_of(const Scene& scene, std::size_t g, std::size_t i, std::uint64_t seed, double perturb);

}  // namespace ballpark::BALLPARK_PRECISION
