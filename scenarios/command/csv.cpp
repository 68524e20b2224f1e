#include "scenarios/command/csv.h"

#include <fmt/format.h>

namespace ballpark::command {
namespace {

/// Rows of all bodies, each after `prefix`; written in pieces, so that memory stays bounded.
void write_rows(const World& world, OutputFile& file, CarriedColumns carried, const std::string& prefix) {
  constexpr std::size_t piece = 1 << 16;
  std::string text;
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    text += prefix;
    append_csv_row(text, id, world.body(id), carried);
    text += '\n';
    if (text.size() >= piece) {
      file.write(text);
      text.clear();
    }
  }
  file.write(text);
}

}  // namespace

void CsvFrames::add(const World& world) {
  if (!carried_) {
    carried_ = carried_columns(world);
    file_.write("time," + csv_header(*carried_) + "\n");
  }
  write_rows(world, file_, *carried_, fmt::format("{:.17g},", world.time()));
}

void write_state(const World& world, OutputFile& file) {
  const CarriedColumns carried = carried_columns(world);
  file.write(csv_header(carried) + "\n");
  write_rows(world, file, carried, "");
}

}  // namespace ballpark::command
