// Watches a run and keeps what a page of it needs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ballpark/world.h"
#include "scenarios/view/film.h"
#include "scenarios/view/history.h"

namespace ballpark::view {

class Recorder {
 public:
  /// `frames`: at most so many will come. `scene` must outlive the recorder.
  Recorder(const Scene& scene, const Options& options, Columns columns, std::size_t frames, Limits limits = {});
  void add(const World& world);
  Recording take();  ///< with notes of what is not shown as it was

 private:
  void begin(const World& world);

  const Scene& scene_;
  int copies_;
  Columns columns_;
  std::size_t frames_;
  Limits limits_;
  Film film_;
  History history_;
};

}  // namespace ballpark::view
