// Denormals cost 20 to 30 times a normal operation: while this object lives, the thread reads and writes them as zero.
#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace ballpark {

class FlushDenormals {
 public:
#ifdef __SSE2__
  FlushDenormals() : saved_(_mm_getcsr()) {
    if (!flushed()) _mm_setcsr(saved_ | flush);
  }
  ~FlushDenormals() {
    if (!flushed()) _mm_setcsr(saved_);
  }

 private:
  static constexpr unsigned flush = 0x8040;  // FTZ and DAZ
  bool flushed() const {
    return (saved_ & flush) == flush;
  }  // by a caller: writing the register is slow
  unsigned saved_;
#elif defined(__aarch64__)
  FlushDenormals() {
    asm volatile("mrs %0, fpcr" : "=r"(saved_));
    asm volatile("msr fpcr, %0" ::"r"(saved_ | (1ul << 24)));  // FZ
  }
  ~FlushDenormals() {
    asm volatile("msr fpcr, %0" ::"r"(saved_));
  }

 private:
  unsigned long saved_;
#else
  FlushDenormals() {}
#endif
 public:
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;
};

}  // namespace ballpark
