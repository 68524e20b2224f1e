// Vectors by slot, component by component.
#pragma once

#include <vector>

#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// One vector for each slot.
struct VectorColumn {
  std::vector<Real> x, y, z;

  void resize(std::size_t n) {
    for (auto* values : {&x, &y, &z}) values->resize(n);
  }
  Vector3<Real> at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void put(std::size_t i, const Vector3<Real>& a) { x[i] = a.x, y[i] = a.y, z[i] = a.z; }
  std::size_t bytes() const { return (x.capacity() + y.capacity() + z.capacity()) * sizeof(Real); }
};

}  // namespace ballpark::BALLPARK_PRECISION
