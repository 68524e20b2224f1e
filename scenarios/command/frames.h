// States of a world, copied out so that another thread can write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::command {

/// A quantity of every body. Rows go by id.
struct FrameColumn {
  std::string name;                ///< one of scenes::output_columns()
  std::vector<std::string> cells;  ///< of its components, as a table heads them: x, y, z
  std::size_t components() const { return cells.size(); }
};

/// All there are, in the order in which files have them.
const std::vector<FrameColumn>& known_columns();

/// What each frame of a series holds.
struct FrameLayout {
  std::size_t bodies = 0;
  std::vector<FrameColumn> columns;  ///< that change from frame to frame
  std::vector<double> radius;        ///< by id, 0 where there is none [m]; empty: not asked for
};

/// Of a series without a frame.
FrameLayout layout_without_bodies(const scenes::OutputRequest& request);

/// Some frames, one after the other.
struct Frames {
  std::vector<double> times;                 ///< [s]
  std::vector<std::vector<double>> columns;  ///< as in the layout: of each frame, body and component

  std::size_t count() const { return times.size(); }
  std::size_t bytes() const;
  void clear();  ///< the memory is kept
  std::span<const double> values(std::size_t column, std::size_t frame) const;
};

/// Ids of the bodies that are there in a frame: those whose position is no NaN. All, if it holds no positions.
std::vector<std::int32_t> present(const FrameLayout& layout, const Frames& frames, std::size_t frame);

/// Copies frames of one world.
class FrameReader {
 public:
  /// The columns that the request chooses; else position, velocity, and orientation and angular velocity if any body
  /// carries them (the others then show identity and zero), and radii if the format is drawn and any body has one.
  FrameReader(const World& world, const Scene& scene, const scenes::OutputRequest& request);
  const FrameLayout& layout() const { return layout_; }
  void add(const World& world, Frames& frames) const;

 private:
  FrameLayout layout_;
  std::vector<std::size_t> rows_;  ///< in the world's views, by id
};

}  // namespace ballpark::command
