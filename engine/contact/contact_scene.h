// What every contact formulation sees of a scene.
#pragma once

#include "engine/collide/near.h"
#include "engine/contact/contact_bodies.h"
#include "engine/contact/impact.h"
#include "engine/contact/wall.h"

namespace ballpark::BALLPARK_PRECISION {

/// Laws of all pairs of materials.
struct LawTable {
  std::vector<ImpactLaw> laws;  ///< of materials i and j: i * materials + j
  std::size_t materials = 0;

  const ImpactLaw& of(std::uint16_t i, std::uint16_t j) const { return laws[i * materials + j]; }
};

/// What contacts do to a body.
struct BodyLoad {
  std::uint32_t contacts = 0;  ///< that press on it
  Vector3<Real> force;         ///< of all of them [N]
  void add(const Vector3<Real>& of_one) { ++contacts, force += of_one; }
};

struct ContactScene {
  std::vector<Wall> walls;
  LawTable laws;
  Period period;
  ContactBodies bodies;
};

}  // namespace ballpark::BALLPARK_PRECISION
