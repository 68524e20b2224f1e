#include "scenarios/command/series.h"

#include <time.h>

#include <utility>

#include "scenarios/command/terminal.h"

namespace ballpark::command {
namespace {

constexpr std::size_t full_batch = 1 << 18;  // bytes
constexpr double longest_delay = 0.2;        // s: frames of slow runs are to be seen soon

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Series::Series(const scenes::OutputRequest& request, const Scene& scene)
    : scene_(scene), request_(request), file_(open_frame_file(request, scene)) {
  cost_.file = frame_file_name(request.file);
  for (std::size_t i = 0; i < batches; ++i) free_.push_back(std::make_unique<Frames>());
}

Series::~Series() {
  end(false);
}

void Series::add(const World& world) {
  if (!reader_) reader_.emplace(world, scene_, request_);
  if (!filling_ && !wait_for_batch()) return;
  const double start = now();
  reader_->add(world, *filling_);
  const double end = now();
  cost_.copying += end - start;
  if (filling_->bytes() >= full_batch || end - handed_over_ > longest_delay) hand_over();
}

/// False if there is no use in more frames.
bool Series::wait_for_batch() {
  const double start = now();
  std::unique_lock lock(mutex_);
  room_.wait(lock, [this] { return failed_ || !free_.empty(); });
  cost_.waiting += now() - start;
  if (failed_) return false;
  filling_ = std::move(free_.front());
  free_.pop_front();
  return true;
}

void Series::hand_over() {
  handed_over_ = now();
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(filling_));
    if (!thread_.joinable()) layout_ = reader_->layout();
  }
  work_.notify_one();
  if (!thread_.joinable()) thread_ = std::thread([this] { write(); });
}

std::optional<std::string> Series::news() {
  const std::lock_guard lock(mutex_);
  if (failure_.empty()) return std::nullopt;
  return std::exchange(failure_, "");
}

bool Series::finish() {
  if (filling_ && filling_->count() > 0) hand_over();
  if (!reader_) layout_ = layout_without_bodies(request_);
  if (!thread_.joinable()) thread_ = std::thread([this] { write(); });
  end(true);
  cost_.failed = failed_;
  return !failed_;
}

void Series::end(bool whole) {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    whole_ = whole;
  }
  work_.notify_one();
  if (thread_.joinable()) thread_.join();
}

// The writing thread: from here on.
void Series::write() {
  try {
    write_all();
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    failure_ = error.what();
    failed_ = true;
  }
  room_.notify_one();
}

void Series::write_all() {
  const auto timed = [this](const auto& action) {
    const double start = now(), cpu_start = cpu_seconds();
    action();
    cost_.writing += now() - start;
    cost_.writing_cpu += cpu_seconds() - cpu_start;
  };
  timed([this] { file_->begin(layout_); });
  while (std::unique_ptr<Frames> batch = next_batch()) {
    timed([&] { file_->add(*batch); });
    cost_.frames += batch->count();
    batch->clear();
    {
      const std::lock_guard lock(mutex_);
      free_.push_back(std::move(batch));
    }
    room_.notify_one();
  }
  if (!whole_) return;
  timed([this] { file_->finish(); });
  cost_.bytes = file_->bytes();
}

/// None when all is written, or given up.
std::unique_ptr<Frames> Series::next_batch() {
  std::unique_lock lock(mutex_);
  work_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
  if (waiting_.empty() || (ended_ && !whole_)) return nullptr;
  std::unique_ptr<Frames> batch = std::move(waiting_.front());
  waiting_.pop_front();
  return batch;
}

}  // namespace ballpark::command
