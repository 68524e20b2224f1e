// Steps of a run that are watched for the file's events.
#pragma once

#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

class EventLog {
 public:
  /// Throws SceneFileError if an event names a quantity that no body's state has.
  EventLog(const SceneFile& file, World& world);
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  bool empty() const { return events_.empty(); }
  /// The steps of World::step, each of them `length` [s].
  void step(std::uint64_t n, double length);
  /// As World::approach, with a tolerance.
  bool approach(double t, double end, std::uint64_t most_steps);
  /// Up to a time at or behind the world's.
  std::vector<EventTimes> until(double t) const;

 private:
  World& world_;
  std::vector<BodyEvent> events_;
  std::vector<EventTimes> noted_;
  std::vector<Watch> watches_;
};

}  // namespace ballpark::scenes
