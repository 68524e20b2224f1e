// The state over time for ParaView: a VTK PolyData file each frame (name_0000.vtp, ...), and name.pvd that lists them
// with their times. Numbers are raw bytes behind the XML. Each body is a point with a vertex, so that it can be drawn.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scenarios/command/frame_file.h"
#include "scenarios/command/output_file.h"

namespace ballpark::command {

class VtpFrames : public FrameFile {
 public:
  VtpFrames(const std::string& index_path, bool single);
  void begin(const FrameLayout& layout) override;
  void add(const Frames& frames) override;
  void finish() override { write_index(); }
  std::uint64_t bytes() const override { return bytes_ + index_bytes_; }

 private:
  void write_numbers(OutputFile& file, std::span<const double> values);
  void write_frame(const Frames& frames, std::size_t frame);
  std::string header(double time) const;
  std::string data_array(const std::string& attributes, std::size_t components, std::size_t size,
                         std::size_t& offset) const;
  bool index_is_due() const;
  void write_index();

  std::string index_path_, stem_;
  bool single_;
  FrameLayout layout_;
  std::string listed_;  ///< entries of the index
  std::size_t frames_ = 0, frames_in_index_ = 0;
  double index_written_ = 0;  ///< [s], of a steady clock
  std::uint64_t bytes_ = 0, index_bytes_ = 0;
  std::vector<std::int32_t> ids_, ends_;  ///< of a frame's points, bodies that are there, and vertices
  std::vector<double> here_;              ///< scratch: their values
};

}  // namespace ballpark::command
