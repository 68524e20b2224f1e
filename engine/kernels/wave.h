// Sine and cosine of a phase in turns.
#pragma once

#include "engine/kernels/rotation_vector.h"

namespace ballpark::BALLPARK_PRECISION {

template <class V>
struct Wave {
  V sine, cosine;
};

/// By those of half the angle, which whole turns taken off leave within a quarter turn.
template <class V>
BALLPARK_INLINE Wave<V> wave(const V& turns) {
  const V two = V(Real(2)), half = V(Real(3.14159265358979323846264338327950288L)) * (turns - nearest_whole(turns));
  const V square = half * half, sine = half * sine_series.at(square);
  return {two * sine * cosine_series.at(square), V(Real(1)) - two * sine * sine};
}

}  // namespace ballpark::BALLPARK_PRECISION
