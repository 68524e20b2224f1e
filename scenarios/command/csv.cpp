#include "scenarios/command/csv.h"

#include "scenarios/command/number_text.h"

namespace ballpark::command {
namespace {

std::string header(const FrameLayout& layout) {
  std::string text = "id";
  for (const FrameColumn& column : layout.columns) {
    for (const std::string& cell : column.cells) text += "," + cell;
  }
  return text + (layout.radius.empty() ? "" : ",radius") + "\n";
}

/// Rows of all bodies, each after `prefix`; written in pieces, so that memory stays bounded.
void write_rows(const FrameLayout& layout, const Frames& frames, std::size_t frame, bool single,
                const std::string& prefix, OutputFile& file) {
  constexpr std::size_t piece = 1 << 16;
  fmt::memory_buffer text;
  const auto append = [&](double value) {
    text.push_back(',');
    append_digits(text, value, single);
  };
  for (std::size_t id = 0; id < layout.bodies; ++id) {
    fmt::format_to(fmt::appender(text), "{}{}", prefix, id);
    for (std::size_t c = 0; c < layout.columns.size(); ++c) {
      const std::size_t n = layout.columns[c].components();
      for (const double value : frames.values(c, frame).subspan(n * id, n)) append(value);
    }
    if (!layout.radius.empty()) append(layout.radius[id]);
    text.push_back('\n');
    if (text.size() < piece) continue;
    file.write({text.data(), text.size()});
    text.clear();
  }
  file.write({text.data(), text.size()});
}

}  // namespace

void CsvFrames::begin(const FrameLayout& layout) {
  layout_ = layout;
  file_.write("time," + header(layout));
}

void CsvFrames::add(const Frames& frames) {
  for (std::size_t frame = 0; frame < frames.count(); ++frame) {
    write_rows(layout_, frames, frame, single_, fmt::format("{:.17g},", frames.times[frame]), file_);
  }
}

void write_state(const World& world, const Scene& scene, OutputFile& file) {
  const FrameReader reader(world, scene, {});
  Frames now;
  reader.add(world, now);
  file.write(header(reader.layout()));
  write_rows(reader.layout(), now, 0, false, "", file);
}

}  // namespace ballpark::command
