#include "scenarios/command/series_text.h"

#include <fmt/format.h>

#include "scenarios/command/text.h"

namespace ballpark::command {

std::string series_text(const std::vector<SeriesCost>& costs) {
  std::size_t frames = 0;
  double written = 0, writing = 0, still = 0;
  std::string missing;
  for (const SeriesCost& cost : costs) {
    frames += cost.frames;
    written += static_cast<double>(cost.bytes);
    writing += cost.writing;
    still += cost.copying + cost.waiting;
    if (cost.failed) missing += "; not all of " + cost.file;
  }
  return fmt::format("{}, {}: {} on {}; stepping stood still for {}{}", counted(frames, "frame", "frames"),
                     bytes(written), seconds(writing), costs.size() > 1 ? "other threads" : "another thread",
                     seconds(still), missing);
}

nlohmann::ordered_json series_json(const std::vector<SeriesCost>& costs) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SeriesCost& cost : costs) {
    list.push_back({{"file", cost.file},
                    {"frames", cost.frames},
                    {"bytes", cost.bytes},
                    {"failed", cost.failed},
                    {"writing_seconds", cost.writing},
                    {"writing_cpu_seconds", cost.writing_cpu},
                    {"copying_seconds", cost.copying},
                    {"waiting_seconds", cost.waiting}});
  }
  return list;
}

}  // namespace ballpark::command
