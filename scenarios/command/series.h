// A series of frames, written on a thread of its own: the run only copies them.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "scenarios/command/frame_file.h"
#include "scenarios/command/frames.h"

namespace ballpark::command {

/// What a series took.
struct SeriesCost {
  std::string file;
  std::size_t frames = 0;  ///< written
  std::uint64_t bytes = 0;
  bool failed = false;                  ///< frames are missing
  double writing = 0, writing_cpu = 0;  ///< by the writing thread: on the clock, and of the processor [s]
  double copying = 0, waiting = 0;      ///< that the run stood still meanwhile [s]
};

/// Frames travel in batches: a few large ones, or many small ones at once. There are never more than `batches`; if all
/// are on their way, the run waits.
class Series {
 public:
  /// Opens the file: throws DestinationError.
  Series(const scenes::OutputRequest& request, const Scene& scene);
  ~Series();  ///< a series that is not finished leaves no file (.vtp: no more of them)
  Series(const Series&) = delete;
  Series& operator=(const Series&) = delete;

  /// Does nothing once writing has failed.
  void add(const World& world);
  /// What failed, if it did. It is told once.
  std::optional<std::string> news();
  /// Writes what is left and puts the file in place. False if it failed, now or before.
  bool finish();
  /// After finish().
  const SeriesCost& cost() const { return cost_; }

 private:
  static constexpr std::size_t batches = 3;

  bool wait_for_batch();
  void hand_over();
  void end(bool whole);
  void write();
  void write_all();
  std::unique_ptr<Frames> next_batch();

  const Scene& scene_;
  scenes::OutputRequest request_;
  std::unique_ptr<FrameFile> file_;
  std::optional<FrameReader> reader_;
  std::unique_ptr<Frames> filling_;
  double handed_over_ = 0;  ///< when the last batch was [s], of a steady clock
  SeriesCost cost_;

  std::mutex mutex_;  ///< for what follows
  std::condition_variable work_, room_;
  std::deque<std::unique_ptr<Frames>> waiting_, free_;
  FrameLayout layout_;
  std::string failure_;
  bool failed_ = false, ended_ = false, whole_ = false;
  std::thread thread_;
};

}  // namespace ballpark::command
