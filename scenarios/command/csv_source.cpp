// Series of frames as CSV: a row per time and body, in the order of ids.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scenarios/command/frame_source.h"

namespace ballpark::command {
namespace {

class CsvSource : public FrameSource {
 public:
  explicit CsvSource(const std::string& path) : path_(path), stream_(path) {
    std::string head;
    if (!std::getline(stream_, head)) refuse_frames(path, "it cannot be read, or is empty");
    read_head(head);
    read_row();
    read_frame();
    if (frame_.empty()) refuse_frames(path, "it has no frame");
    layout_.bodies = frame_.size() / cells_;
    if (radius_ < cells_) {
      for (std::size_t id = 0; id < layout_.bodies; ++id) layout_.radius.push_back(frame_[id * cells_ + radius_]);
    }
    const double first_bytes = static_cast<double>(read_bytes_) * static_cast<double>(layout_.bodies) /
                               static_cast<double>(std::max<std::size_t>(line_ - 1, 1));
    const auto all = static_cast<double>(std::filesystem::file_size(path));
    frames_ = static_cast<std::size_t>(std::ceil(all / first_bytes));
  }

  std::size_t frames() const override { return frames_; }

  bool next(Frames& frame) override {
    if (frame_.empty()) return false;
    frame.columns.resize(layout_.columns.size());
    frame.clear();
    frame.times.push_back(frame_[0]);
    for (std::size_t c = 0; c < layout_.columns.size(); ++c) {
      const std::size_t n = layout_.columns[c].components();
      for (std::size_t id = 0; id < layout_.bodies; ++id) {
        const auto cell = frame_.begin() + static_cast<std::ptrdiff_t>(id * cells_ + places_[c]);
        frame.columns[c].insert(frame.columns[c].end(), cell, cell + static_cast<std::ptrdiff_t>(n));
      }
    }
    const double time = frame_[0];
    read_frame();
    if (!frame_.empty() && frame_.size() != layout_.bodies * cells_) {
      refuse(fmt::format("the frame of {} s has {} of {} bodies", frame_[0], frame_.size() / cells_, layout_.bodies));
    }
    if (!frame_.empty() && frame_[0] <= time) refuse("its times do not ascend");
    return true;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    refuse_frames(path_, fmt::format("line {}: {}", line_, why));
  }

  void read_head(const std::string& head) {
    std::vector<std::string> names;
    std::istringstream cells(head.substr(0, head.find('\r')));
    for (std::string cell; std::getline(cells, cell, ',');) names.push_back(cell);
    cells_ = names.size();
    if (cells_ < 2 || names[0] != "time" || names[1] != "id") {
      refuse_frames(path_, "its first line does not begin with time,id as series of `ballpark run --out` do");
    }
    radius_ = static_cast<std::size_t>(std::find(names.begin(), names.end(), "radius") - names.begin());
    for (const FrameColumn& column : known_columns()) {
      const auto found = std::search(names.begin(), names.end(), column.cells.begin(), column.cells.end());
      if (found == names.end()) continue;
      layout_.columns.push_back(column);
      places_.push_back(static_cast<std::size_t>(found - names.begin()));
    }
  }

  /// The rows of one time.
  void read_frame() {
    frame_.clear();
    while (!row_.empty() && (frame_.empty() || row_[0] == frame_[0])) {
      if (row_[1] != static_cast<double>(frame_.size() / cells_)) refuse("rows are not in the order of id");
      frame_.insert(frame_.end(), row_.begin(), row_.end());
      read_row();
    }
  }

  /// Empty at the end of the file.
  void read_row() {
    row_.clear();
    std::string line;
    ++line_;
    if (!std::getline(stream_, line)) return;
    read_bytes_ += line.size() + 1;
    const char* at = line.data();
    const char* end = at + line.size() - (line.ends_with('\r') ? 1 : 0);
    while (at < end) {
      double number = 0;
      const auto [after, error] = std::from_chars(at, end, number);
      const bool whole = error == std::errc{} && (after == end || *after == ',');
      if (!whole) break;
      row_.push_back(number);
      at = after + 1;
    }
    if (at < end || row_.size() != cells_) refuse(fmt::format("expected {} numbers", cells_));
  }

  std::string path_;
  std::ifstream stream_;
  std::size_t cells_ = 0, radius_ = 0, line_ = 1, read_bytes_ = 0, frames_ = 0;
  std::vector<std::size_t> places_;  ///< of each column's first cell in a row
  std::vector<double> row_, frame_;  ///< the row after the frame, and the frame that comes next
};

}  // namespace

std::unique_ptr<FrameSource> open_csv(const std::string& path) {
  return std::make_unique<CsvSource>(path);
}

}  // namespace ballpark::command
