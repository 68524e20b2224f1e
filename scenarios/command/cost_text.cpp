#include "scenarios/command/cost_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/choice.h"
#include "perf/cost/subject.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

using cost::Curve;
using cost::Point;
using cost::Result;

constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;

std::string error_text(double error) {
  return error > 0 ? fmt::format("{:.1e}", error) : "0";
}

/// "2.3e-07", "< 1.0e-14" where no more is claimed, "other count".
std::string event_text(const Point& point, double floor) {
  if (!point.errors.events.different.empty()) return "other count";
  if (!std::isfinite(floor)) return "unknown";
  const double error = point.errors.events.time;
  return (error < floor ? "< " : "") + error_text(std::max(error, floor));
}

std::string reference_events(const Result& result) {
  std::string names;
  for (const scenes::EventTimes& event : result.events) {
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", grouped(event.count), event.name);
  }
  const double bar = result.reference.event_bar;
  const std::string sure = std::isfinite(bar) ? fmt::format("known to {} s; no error below {} s is claimed",
                                                            error_text(bar), error_text(result.event_floor()))
                                              : "two reference runs differ in how many there are: no error is claimed";
  return names + ", " + sure;
}

}  // namespace

void add_ground(Page& page, const cost::Result& result) {
  const auto bar = result.reference.error_bar[static_cast<std::size_t>(result.quantity)];
  const std::string compared =
      result.compared < result.bodies ? fmt::format(", {} of them compared", grouped(result.compared)) : "";
  std::vector<std::pair<std::string, Cell>> fields{
      {"bodies", grouped(result.bodies) + compared},
      {"duration", number(result.duration) + " s"},
      {"error", fmt::format("{} [{}]", result.measure, result.measure_unit)},
      {"reference", fmt::format("{}: {}", result.reference.kind, result.reference.what)},
      {"its own error",
       fmt::format("{} {}; none below {} is claimed", error_text(bar), result.measure_unit, error_text(result.floor))},
      {"machine", fmt::format("{}, {}", result.machine,
                              counted(static_cast<std::uint64_t>(result.threads), "thread", "threads"))}};
  if (!result.events.empty()) fields.insert(fields.end() - 1, {"events", reference_events(result)});
  page.fields(std::move(fields));
  for (const std::string& remark : result.remarks) page.paragraph(remark);
  if (result.horizon) page.paragraph(result.horizon->sentence);
}

namespace {

void add_front(Page& page, const Result& result) {
  std::vector<const Point*> front;
  for (const Point& point : result.points) {
    if (point.front) front.push_back(&point);
  }
  std::sort(front.begin(), front.end(), [](auto* a, auto* b) { return a->error > b->error; });
  page.heading("Pareto front: no setting is as accurate and faster");
  Table table{{{"error", right}, {"time", right}, {"median", right}, {"evaluations", right}, {"setting", wrap}}, {}};
  if (!result.events.empty()) table.columns.insert(table.columns.begin() + 1, {"event times [s]", right});
  for (const Point* point : front) {
    const std::string below = point->claimed ? "" : "< ";
    table.rows.push_back({Cell(below + error_text(std::max(point->error, result.floor)), Style::strong),
                          seconds(point->seconds.minimum), seconds(point->seconds.median),
                          grouped(point->force_evaluations), text(point->setting)});
    if (!result.events.empty())
      table.rows.back().insert(table.rows.back().begin() + 1, event_text(*point, result.event_floor()));
  }
  page.table(table);
}

/// Powers of ten from the largest error worth a column down to the smallest that was met.
std::vector<double> columns_of(const Result& result) {
  double best = 1e300, worst = 0;
  for (const Point& point : result.points) {
    if (!cost::counts(point) || !point.front) continue;
    best = std::min(best, std::max(point.error, result.floor));
    worst = std::max(worst, point.error);
  }
  const int last = static_cast<int>(std::ceil(std::log10(best)));
  const int first = std::min(static_cast<int>(std::floor(std::log10(worst))), last + 14);
  const int stride = std::max(1, (first - last + 4) / 5);
  std::vector<double> columns;
  for (int exponent = last; exponent <= first; exponent += stride)
    columns.insert(columns.begin(), std::pow(10, exponent));
  return columns;
}

/// Least time of a measured point of the curve at most that far off; 0: none is.
double time_to(const Result& result, const Curve& curve, double error) {
  double least = 0;
  for (const std::size_t i : curve.points) {
    const Point& point = result.points[i];
    if (!cost::counts(point) || std::max(point.error, result.floor) > error * (1 + 1e-9)) continue;
    if (least == 0 || point.seconds.minimum < least) least = point.seconds.minimum;
  }
  return least;
}

void add_curves(Page& page, const Result& result) {
  const std::vector<double> columns = columns_of(result);
  if (columns.empty()) return;
  page.heading(fmt::format("Time to an error [{}]: the cheapest setting measured", result.measure_unit));
  Table table{{{"integrator", wrap}}, {}};
  std::vector<double> least(columns.size(), 0);
  std::vector<std::pair<std::vector<double>, const Curve*>> rows;
  for (const Curve& curve : result.curves) {
    std::vector<double> times;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      times.push_back(time_to(result, curve, columns[c]));
      if (times[c] > 0 && (least[c] == 0 || times[c] < least[c])) least[c] = times[c];
    }
    if (std::any_of(times.begin(), times.end(), [](double t) { return t > 0; })) rows.emplace_back(times, &curve);
  }
  for (const double column : columns) table.columns.push_back({fmt::format("{:.0e}", column), right});
  // Those that reach farthest first, the faster before the slower.
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    for (std::size_t c = a.first.size(); c-- > 0;) {
      if ((a.first[c] > 0) != (b.first[c] > 0)) return a.first[c] > 0;
      if (a.first[c] != b.first[c]) return a.first[c] < b.first[c];
    }
    return false;
  });
  for (const auto& [times, curve] : rows) {
    std::vector<Cell> cells{Cell(curve->label)};
    for (std::size_t c = 0; c < columns.size(); ++c) {
      cells.emplace_back(times[c] > 0 ? seconds(times[c]) : "-", times[c] == least[c] ? Style::good : Style::plain);
    }
    table.rows.push_back(std::move(cells));
  }
  page.table(table);
}

/// What a step of a curve costs, by its finest setting that counts.
struct Price {
  const Curve* curve;
  const Point* point;
  double seconds() const { return point->seconds.minimum / static_cast<double>(point->steps); }
};

std::vector<Price> prices_of(const Result& result) {
  std::vector<Price> prices;
  for (const Curve& curve : result.curves) {
    const Point* finest = nullptr;
    for (const std::size_t i : curve.points) {
      const Point& point = result.points[i];
      if (point.setting.step > 0 && point.steps > 0 && cost::counts(point)) finest = &point;
    }
    if (finest && curve.precision == Precision::double_) prices.push_back({&curve, finest});
  }
  std::sort(prices.begin(), prices.end(), [](const Price& a, const Price& b) { return a.seconds() < b.seconds(); });
  return prices;
}

void add_prices(Page& page, const Result& result) {
  const std::vector<Price> prices = prices_of(result);
  if (prices.empty()) return;
  page.heading("Price of a step");
  Table table{{{"integrator", wrap}, {"evaluations", right}, {"ns a body-step", right}, {"of euler's", right}}, {}};
  for (const Price& price : prices) {
    const cost::Setting& setting = price.point->setting;
    std::string of_euler = "-";  // with the same contacts
    for (const Price& other : prices) {
      const cost::Setting& euler = other.point->setting;
      const bool alike = euler.contact == setting.contact && euler.rotation == setting.rotation &&
                         euler.opening_angle == setting.opening_angle;
      if (euler.integrator == "euler" && alike) of_euler = fmt::format("{:.2f}", price.seconds() / other.seconds());
    }
    const auto steps = static_cast<double>(price.point->steps);
    table.rows.push_back({price.curve->label, number(static_cast<double>(price.point->force_evaluations) / steps, 3),
                          number(1e9 * price.seconds() / static_cast<double>(result.bodies), 4), of_euler});
  }
  page.table(table);
}

}  // namespace

double overall(const std::string& what, double fraction) {
  const double starts[] = {0, 0.15, 0.4, 0.8, 0.85, 1};
  const char* parts[] = {"reference", "sweep", "timing", "confirming", "ensembles"};
  for (std::size_t i = 0; i < std::size(parts); ++i) {
    if (what == parts[i]) return starts[i] + (starts[i + 1] - starts[i]) * std::clamp(fraction, 0.0, 1.0);
  }
  return 0;
}

std::string cost_text(const Result& result) {
  Page text = page();
  text.heading(result.scenario);
  add_ground(text, result);
  text.paragraph(fmt::format("{} settings on {} curves; whole runs, timed in turns.", grouped(result.points.size()),
                             grouped(result.curves.size())));
  const bool any = std::any_of(result.points.begin(), result.points.end(), [](auto& point) { return point.front; });
  if (any) {
    add_front(text, result);
    add_curves(text, result);
    add_prices(text, result);
  }
  if (!result.crossovers.empty()) text.heading("Crossovers");
  text.list(result.crossovers);
  if (result.ensemble) add_ensemble(text, *result.ensemble);
  if (!any) text.paragraph("No setting that was tried gives an answer: see what was left out, and why.");
  if (!result.left_out.empty()) text.heading("Left out");
  text.list(result.left_out);
  if (result.recommended) {
    text.heading("Recommended");
    text.paragraph(result.recommended->sentence);
  }
  return text.text();
}

}  // namespace ballpark::command
