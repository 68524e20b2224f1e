// Columns of bodies as arrays that a careful programmer would allocate.
#pragma once

#include <algorithm>
#include <memory>
#include <new>
#include <vector>

#include "perf/throughput/subject.h"

namespace ballpark::perf {

/// Each starts on a cache line and has room for a vector behind the last body.
class BareArrays {
 public:
  explicit BareArrays(const StateColumns& columns) : count_(columns.front().size()) {
    for (const std::vector<double>& column : columns) {
      const std::size_t room = count_ + line / sizeof(double);
      arrays_.emplace_back(static_cast<double*>(::operator new (room * sizeof(double), std::align_val_t{line})));
      std::copy(column.begin(), column.end(), arrays_.back().get());
      std::fill(arrays_.back().get() + count_, arrays_.back().get() + room, 1.0);
      pointers_.push_back(arrays_.back().get());
    }
  }
  std::size_t count() const { return count_; }
  double* operator[](std::size_t c) const { return pointers_[c]; }
  double* const* data() const { return pointers_.data(); }
  StateColumns columns() const {
    StateColumns copies;
    for (const double* array : pointers_) copies.emplace_back(array, array + count_);
    return copies;
  }

 private:
  static constexpr std::size_t line = 64;
  struct Free {
    void operator()(double* array) const { ::operator delete (array, std::align_val_t{line}); }
  };
  std::size_t count_;
  std::vector<std::unique_ptr<double, Free>> arrays_;
  std::vector<double*> pointers_;
};

}  // namespace ballpark::perf
