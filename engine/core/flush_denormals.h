// Denormals cost 20 to 30 times a normal operation: while this object lives, the thread reads and writes them as zero.
#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace ballpark {

/// May be nested: only the outermost touches the register, for which the processor must finish all that is under way.
class FlushDenormals {
 public:
  FlushDenormals() : outermost_(!active_) {
    if (!outermost_) return;
    active_ = true;
#ifdef __SSE2__
    saved_ = _mm_getcsr();
    _mm_setcsr(saved_ | 0x8040u);  // FTZ and DAZ
#elif defined(__aarch64__)
    asm volatile("mrs %0, fpcr" : "=r"(saved_));
    asm volatile("msr fpcr, %0" ::"r"(saved_ | (1ul << 24)));  // FZ
#endif
  }
  ~FlushDenormals() {
    if (!outermost_) return;
    active_ = false;
#ifdef __SSE2__
    _mm_setcsr(saved_);
#elif defined(__aarch64__)
    asm volatile("msr fpcr, %0" ::"r"(saved_));
#endif
  }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  static inline thread_local bool active_ = false;
  bool outermost_;
#ifdef __SSE2__
  unsigned saved_ = 0;
#elif defined(__aarch64__)
  unsigned long saved_ = 0;
#endif
};

}  // namespace ballpark
