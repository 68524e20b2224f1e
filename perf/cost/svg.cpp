#include "perf/cost/svg.h"

#include <fmt/format.h>

#include "perf/cost/draw/chart.h"

namespace ballpark::cost {

namespace {

using namespace draw;

constexpr double width = 1000, left = 104, right = 930, chart_height = 560;

std::string reference_text(const Result& result) {
  const std::string unit = result.measure_unit.empty() ? "" : " " + result.measure_unit;
  const double bar = result.reference.error_bar[static_cast<std::size_t>(result.quantity)];
  std::string text = "Reference: " + result.reference.kind;
  if (!result.reference.what.empty()) text += ", " + result.reference.what;
  if (bar > 0) text += "; itself within " + number(bar) + unit;
  if (result.floor > 0) text += "; no error below " + number(result.floor) + unit + " is claimed";
  return text + ".";
}

/// Returns where the next line may begin.
double draw_head(Canvas& canvas, const Result& result) {
  double y = 36;
  canvas.text({24, y}, result.scenario + ": what accuracy costs", 21,
              fmt::format("fill=\"{}\" font-weight=\"600\"", dark));
  const auto paragraph = [&](const std::string& words, const char* colour, const char* font) {
    for (const std::string& line : lines_of(words, 13, width - 48)) {
      y += 19;
      canvas.text({24, y}, line, 13, fmt::format("fill=\"{}\"{}", colour, font));
    }
  };
  y += 3;
  if (!result.doc.empty()) paragraph(result.doc, dark, "");
  if (!result.reference.kind.empty()) paragraph(reference_text(result), medium, "");
  for (const std::string& remark : result.remarks) paragraph(remark, medium, "");
  if (result.horizon && !result.horizon->sentence.empty()) paragraph(result.horizon->sentence, medium, "");
  std::string setup = fmt::format("{} s simulated", number(result.duration));
  if (result.compared < result.bodies)
    setup += fmt::format(", {} of {} bodies compared", result.compared, result.bodies);
  setup += fmt::format(", {}, {} thread{}", result.machine, result.threads, result.threads == 1 ? "" : "s");
  paragraph(setup, medium, "");
  paragraph("$ " + result.command, medium, " font-family=\"ui-monospace, Menlo, Consolas, monospace\"");
  return y;
}

}  // namespace

std::string svg(const Result& result) {
  Canvas body;
  const double top = draw_head(body, result) + 50;
  draw_key(body, result, {left, top - 16});
  const Box plot{left, top, right, top + chart_height};
  Chart(result, plot, {left + 2, top + 2, width - 8, top + chart_height - 2}).draw(body);
  double height = plot.bottom + 74;
  if (!result.paths.empty()) {
    body.text({24, height + 22}, "Paths", 16, fmt::format("fill=\"{}\" font-weight=\"600\"", dark));
    height += 36;
    height += draw_paths(body, result, {left, height}, width - left - 8) + 20;
  }
  Canvas whole;
  whole.raw(
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
                  "height=\"{1}\" role=\"img\" font-family=\"system-ui, -apple-system, 'Segoe UI', "
                  "'Helvetica Neue', Arial, sans-serif\">\n<title>{2}: error against wall time</title>\n",
                  coordinate(width), coordinate(height), escaped(result.scenario)));
  whole.box({0, 0, width, height}, "fill=\"#ffffff\"");
  whole.raw(body.text() + "</svg>\n");
  return whole.text();
}

}  // namespace ballpark::cost
