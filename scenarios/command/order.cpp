// ballpark order: the order that each integrator shows on a scene.
#include "perf/cost/order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/command/commands.h"
#include "scenarios/command/cost_options.h"
#include "scenarios/command/cost_text.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;
constexpr double full = 0.3;      ///< a slope this near to the order is the order
constexpr std::size_t shown = 2;  ///< slopes

/// The finest slopes that are not rounding's, from coarse to fine.
std::string slopes_text(const cost::ObservedOrder& row) {
  std::string text;
  const std::size_t count = row.slopes.size();
  for (std::size_t k = count > shown ? count - shown : 0; k < count; ++k) {
    text += fmt::format("{}{:.2f}", text.empty() ? "" : "  ", row.slopes[k]);
  }
  return text;
}

Cell verdict(const cost::ObservedOrder& row) {
  if (!row.observed) return row.trouble.empty() ? "too few runs" : row.trouble;
  const double off = *row.observed - row.order;
  if (off < -full) return Cell(fmt::format("loses {:.1f}", -off), Style::bad);
  return off > full ? Cell("more", Style::good) : Cell("its order", Style::good);
}

std::string finest_error(const cost::ObservedOrder& row, double floor) {
  if (row.errors.empty()) return "-";
  return fmt::format("{}{:.1e}", row.errors.back() < floor ? "< " : "", std::max(row.errors.back(), floor));
}

std::string order_text(const cost::OrderStudy& study) {
  Page text = page();
  text.heading(study.about.scenario);
  add_ground(text, study.about);
  text.heading("Observed order: log2 of the error's fall as the step is halved");
  Table table{
      {{"integrator"}, {"order", right}, {"observed", right}, {"", wrap}, {"finest error", right}, {"slopes", right}},
      {}};
  for (const cost::ObservedOrder& row : study.rows) {
    table.rows.push_back({row.integrator, number(row.order),
                          Cell(row.observed ? fmt::format("{:.2f}", *row.observed) : "-", Style::strong), verdict(row),
                          finest_error(row, study.about.floor), slopes_text(row)});
  }
  text.table(table);
  text.paragraph("Errors near rounding, and those too large to follow a power of the step, do not count.");
  if (!study.about.left_out.empty()) text.heading("Left out");
  text.list(study.about.left_out);
  return text.text();
}

Json order_json(const cost::OrderStudy& study) {
  Json rows = Json::array();
  for (const cost::ObservedOrder& row : study.rows) {
    rows.push_back({{"integrator", row.integrator},
                    {"order", row.order},
                    {"observed", row.observed ? Json(*row.observed) : Json(nullptr)},
                    {"steps", row.steps},
                    {"errors", row.errors},
                    {"slopes", row.slopes},
                    {"trouble", row.trouble.empty() ? Json(nullptr) : Json(row.trouble)}});
  }
  const cost::Result& about = study.about;
  return {{"format", "ballpark-order-1"},
          {"scenario", about.scenario},
          {"duration", about.duration},
          {"measure", about.measure},
          {"unit", about.measure_unit},
          {"reference", {{"kind", about.reference.kind}, {"what", about.reference.what}, {"floor", about.floor}}},
          {"rows", rows},
          {"left_out", about.left_out}};
}

}  // namespace

Exit order_of_accuracy(const Arguments& arguments) {
  const scenes::SceneFile file = load_scene(arguments);
  cost::Request request = cost_request(arguments, file.scene);
  if (!arguments.seconds) request.seconds = 20;
  Delivery delivery(arguments);
  watch_for_interrupt();
  std::optional<cost::OrderStudy> study;
  {
    Progress progress("measuring", !arguments.quiet);
    study = cost::observed_orders(file.scene, request, [&](const std::string& what, double fraction) {
      progress.show(what == "sweep" ? 0.25 + 0.75 * fraction : 0.25 * fraction);
      return !interrupted();
    });
  }
  if (interrupted()) return interrupted_exit;
  if (!study) {
    complain(no_reference);
    return check_failed;
  }
  delivery.text(order_text(*study));
  delivery.json(order_json(*study).dump(2));
  return done;
}

}  // namespace ballpark::command
