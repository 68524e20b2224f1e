// The vector value types of kernels: one quantity of several bodies. Every kernel is a template on V and runs on
// SimdLanes, or on plain Real (diagnostics, and the scalar oracle of the tests).
// Compilers' vector types rather than std::experimental::simd: clang 16 drops the latter's masked assignment on
// AVX-512.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

#if defined(__AVX512F__)
inline constexpr std::size_t register_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;  // SSE2, NEON
#endif

/// Machine registers side by side: independent chains of operations hide each other's latency. `bytes` keeps the types
/// of different targets apart.
template <class T, int registers, std::size_t bytes = register_bytes>
struct SimdLanes {
  using Word = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
  typedef T Register __attribute__((vector_size(bytes)));
  typedef Word RegisterMask __attribute__((vector_size(bytes)));
  struct Mask {
    RegisterMask part[registers];  ///< all bits of a lane set: true
  };
  static constexpr std::size_t width = bytes / sizeof(T);  ///< lanes of one register

  Register part[registers];

  SimdLanes() = default;
  // Register by register: gcc would copy the whole through memory.
  BALLPARK_INLINE SimdLanes(const SimdLanes& b) { *this = b; }
  BALLPARK_INLINE SimdLanes& operator=(const SimdLanes& b) {
    for (int r = 0; r < registers; ++r) part[r] = b.part[r];
    return *this;
  }
  BALLPARK_INLINE explicit SimdLanes(T value) {
    for (Register& r : part) r = value - Register{};  // a broadcast: x - (+0) is x, for -0 too
  }
  BALLPARK_INLINE T operator[](std::size_t lane) const { return part[lane / width][lane % width]; }

  BALLPARK_INLINE SimdLanes operator-() const {
    SimdLanes v;
    for (int r = 0; r < registers; ++r) v.part[r] = -part[r];
    return v;
  }
#define BALLPARK_ARITHMETIC(op)                                                   \
  BALLPARK_INLINE SimdLanes& operator op##=(const SimdLanes& b) {                 \
    for (int r = 0; r < registers; ++r) part[r] op## = b.part[r];                 \
    return *this;                                                                 \
  }                                                                               \
  BALLPARK_INLINE friend SimdLanes operator op(SimdLanes a, const SimdLanes& b) { \
    return a op## = b;                                                            \
  }
  BALLPARK_ARITHMETIC(+)
  BALLPARK_ARITHMETIC(-)
  BALLPARK_ARITHMETIC(*)
  BALLPARK_ARITHMETIC(/)
#undef BALLPARK_ARITHMETIC
#define BALLPARK_COMPARISON(op)                                                     \
  BALLPARK_INLINE friend Mask operator op(const SimdLanes& a, const SimdLanes& b) { \
    Mask mask;                                                                      \
    for (int r = 0; r < registers; ++r) mask.part[r] = a.part[r] op b.part[r];      \
    return mask;                                                                    \
  }
  BALLPARK_COMPARISON(>)
  BALLPARK_COMPARISON(==)
  BALLPARK_COMPARISON(!=)
#undef BALLPARK_COMPARISON
};

/// Extended precision has no vector registers.
template <int registers>
using LanesOf = std::conditional_t<std::is_same_v<Real, long double>, Real, SimdLanes<Real, registers>>;
using Lanes = LanesOf<1>;

template <class V>
inline constexpr std::size_t lane_count = sizeof(V) / sizeof(Real);

template <class V>
BALLPARK_INLINE V load(const Real* p) {
  if constexpr (lane_count<V> == 1) {
    return V(*p);
  } else {
    V v;
    for (auto& r : v.part) {
      __builtin_memcpy(&r, p, sizeof r);
      p += V::width;
    }
    return v;
  }
}

template <class V>
BALLPARK_INLINE void store(Real* p, const V& v) {
  if constexpr (std::is_same_v<V, Real>) {
    *p = v;
  } else {
    for (const auto& r : v.part) {
      __builtin_memcpy(p, &r, sizeof r);
      p += V::width;
    }
  }
}

#if defined(__SSE2__)
// Vector types have no square root of their own, and gcc does not always make one instruction of a loop over lanes.
BALLPARK_INLINE __m128 root_of_register(__m128 v) {
  return _mm_sqrt_ps(v);
}
BALLPARK_INLINE __m128d root_of_register(__m128d v) {
  return _mm_sqrt_pd(v);
}
#if defined(__AVX__)
BALLPARK_INLINE __m256 root_of_register(__m256 v) {
  return _mm256_sqrt_ps(v);
}
BALLPARK_INLINE __m256d root_of_register(__m256d v) {
  return _mm256_sqrt_pd(v);
}
#endif
#if defined(__AVX512F__)
BALLPARK_INLINE __m512 root_of_register(__m512 v) {
  return _mm512_sqrt_ps(v);
}
BALLPARK_INLINE __m512d root_of_register(__m512d v) {
  return _mm512_sqrt_pd(v);
}
#endif
#else
template <class Register>
BALLPARK_INLINE Register root_of_register(Register r) {
  for (std::size_t lane = 0; lane < sizeof r / sizeof(Real); ++lane) {
    r[lane] = sizeof(Real) == 4 ? __builtin_sqrtf(r[lane]) : __builtin_sqrt(r[lane]);
  }
  return r;
}
#endif

/// Correctly rounded.
template <class V>
BALLPARK_INLINE V square_root(V v) {
  if constexpr (std::is_same_v<V, float>) {
    return __builtin_sqrtf(v);
  } else if constexpr (std::is_same_v<V, double>) {
    return __builtin_sqrt(v);
  } else if constexpr (std::is_same_v<V, long double>) {
    return __builtin_sqrtl(v);
  } else {
    for (auto& r : v.part) r = root_of_register(r);
    return v;
  }
}

/// `yes` where the mask holds, else `no`.
template <class V, class Mask>
BALLPARK_INLINE V select(const Mask& mask, const V& yes, const V& no) {
  if constexpr (std::is_same_v<Mask, bool>) {
    return mask ? yes : no;
  } else {
    V v;
    int r = 0;
    for (auto& part : v.part) {
      part = mask.part[r] ? yes.part[r] : no.part[r];
      ++r;
    }
    return v;
  }
}

/// Does any lane differ from zero (NaN does)?
template <class V>
BALLPARK_INLINE bool any_nonzero(const V& v) {
  if constexpr (std::is_same_v<V, Real>) {
    return v != Real(0);
  } else {
    bool any = false;
    for (std::size_t lane = 0; lane < lane_count<V>; ++lane) any |= v[lane] != Real(0);
    return any;
  }
}

/// The largest of all lanes.
template <class V>
BALLPARK_INLINE Real largest(const V& v) {
  if constexpr (std::is_same_v<V, Real>) {
    return v;
  } else {
    Real most = v[0];
    for (std::size_t lane = 1; lane < lane_count<V>; ++lane) most = v[lane] > most ? v[lane] : most;
    return most;
  }
}

/// 0, 1, ...: each lane's number as a value.
template <class V>
BALLPARK_INLINE V lane_numbers() {
  Real numbers[lane_count<V>];
  for (std::size_t lane = 0; lane < lane_count<V>; ++lane) numbers[lane] = static_cast<Real>(lane);
  return load<V>(numbers);
}

}  // namespace ballpark::BALLPARK_PRECISION
