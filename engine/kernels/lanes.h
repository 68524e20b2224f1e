// The vector value type of kernels: `Lanes` holds one quantity of several bodies. Every kernel is a template on V and
// runs on Lanes, or on plain Real (diagnostics, and the scalar oracle of the tests).
#pragma once

#include <cstddef>
#include <experimental/simd>
#include <type_traits>

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

namespace simd = std::experimental;
using Lanes = std::conditional_t<std::is_same_v<Real, long double>, Real, simd::native_simd<Real>>;

template <class V>
inline constexpr std::size_t lane_count = sizeof(V) / sizeof(Real);

template <class V>
BALLPARK_INLINE V load(const Real* p) {
  if constexpr (std::is_same_v<V, Real>) {
    return *p;
  } else {
    return V(p, simd::element_aligned);
  }
}

template <class V>
BALLPARK_INLINE void store(Real* p, V v) {
  if constexpr (std::is_same_v<V, Real>) {
    *p = v;
  } else {
    v.copy_to(p, simd::element_aligned);
  }
}

template <class V>
BALLPARK_INLINE V square_root(V v) {
  if constexpr (std::is_same_v<V, float>) {
    return __builtin_sqrtf(v);
  } else if constexpr (std::is_same_v<V, double>) {
    return __builtin_sqrt(v);
  } else if constexpr (std::is_same_v<V, long double>) {
    return __builtin_sqrtl(v);
  } else {
    return simd::sqrt(v);
  }
}

/// `yes` where the mask holds, else `no`.
template <class V, class Mask>
BALLPARK_INLINE V select(Mask mask, V yes, V no) {
  if constexpr (std::is_same_v<Mask, bool>) {
    return mask ? yes : no;
  } else {
    simd::where(mask, no) = yes;
    return no;
  }
}

/// Does any lane differ from zero (NaN does)?
template <class V>
BALLPARK_INLINE bool any_nonzero(V v) {
  if constexpr (std::is_same_v<V, Real>) {
    return v != Real(0);
  } else {
    return simd::any_of(v != V(Real(0)));
  }
}

/// 0, 1, ...: each lane's number as a value.
template <class V>
BALLPARK_INLINE V lane_numbers() {
  if constexpr (std::is_same_v<V, Real>) {
    return Real(0);
  } else {
    return V([](auto lane) { return static_cast<Real>(lane); });
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
