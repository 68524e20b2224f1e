// Real: the arithmetic type of an engine source. Each is compiled once per precision, into a namespace of its own.
#pragma once

namespace ballpark::f32 {
using Real = float;
}
namespace ballpark::f64 {
using Real = double;
}
namespace ballpark::extended {
using Real = long double;
}

#ifdef BALLPARK_SANITIZE  // a kernel whose every part is inlined and instrumented takes many minutes to compile
#define BALLPARK_INLINE inline
#define BALLPARK_INLINE_LAMBDA
#else
#define BALLPARK_INLINE [[gnu::always_inline]] inline
#define BALLPARK_INLINE_LAMBDA __attribute__((always_inline))
#endif
