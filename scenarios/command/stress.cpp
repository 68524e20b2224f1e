// ballpark stress: the hard cases with their limits.
#include "scenarios/files/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/expectation_text.h"
#include "scenarios/command/scenario_folder.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"
#include "scenarios/files/report_json.h"

namespace ballpark::command {
namespace {

using scenes::CaseResult;
using scenes::CellResult;
using scenes::StressCase;
using scenes::Verdict;

/// Those named; else all of the classes asked for.
std::vector<StressCase> chosen_cases(const Arguments& arguments) {
  std::vector<StressCase> cases;
  for (const std::string& name : arguments.names) cases.emplace_back(stress_path(name));
  if (!arguments.names.empty()) return cases;
  for (const Scenario& scenario : stress_cases()) {
    StressCase one(scenario.file);
    if (arguments.long_cases || one.file().stress->length == "quick") cases.push_back(std::move(one));
  }
  if (cases.empty()) throw UsageError("there are no hard cases in the scenarios' folder (`ballpark list stress`)");
  return cases;
}

std::size_t cells_of(const std::vector<StressCase>& cases) {
  std::size_t count = 0;
  for (const StressCase& one : cases) count += one.cells();
  return count;
}

/// Runs all cells, while nobody interrupts.
std::vector<CaseResult> results_of(const std::vector<StressCase>& cases, const Arguments& arguments) {
  const Options options = run_options(arguments);
  const auto all = static_cast<double>(std::max<std::size_t>(cells_of(cases), 1));
  Progress progress("hard cases", !arguments.quiet);
  std::vector<CaseResult> results;
  double run = 0;
  scenes::RunHooks hooks;
  hooks.progress = [&](double fraction) {
    progress.show((run + fraction) / all);
    return !interrupted();
  };
  for (const StressCase& one : cases) {
    results.push_back(one.empty_result());
    for (std::size_t cell = 0; cell < one.cells() && !interrupted(); ++cell, ++run) {
      results.back().cells.push_back(one.run(cell, options, hooks));
    }
  }
  return results;
}

Cell verdict_cell(const CellResult& cell) {
  if (cell.held) return Cell("held", Style::good);
  return Cell(cell.owed ? "FAILED" : "fails", cell.owed ? Style::bad : Style::faint);
}

/// What was measured, what it may be, and what it was.
std::vector<Cell> measured_cells(const CellResult& cell) {
  const Verdict* verdict = scenes::decisive(cell.verdicts);
  const std::string said = cell.said.empty() ? "no" : cell.said;
  if (!cell.refused.empty()) return {"refused, or reported", "\"" + cell.refused + "\"", cell.held ? "yes" : said};
  const bool unasked = cell.reported.empty() ? !cell.said.empty() : cell.said.find(cell.reported) == std::string::npos;
  if (unasked || !verdict) return {"reported", cell.reported.empty() ? "no" : "\"" + cell.reported + "\"", said};
  return {verdict->expectation.quantity, wanted(verdict->expectation),
          std::isnan(verdict->time) ? "not reached" : number(verdict->measured, digits_of(verdict->expectation))};
}

void add_case(Page& text, const CaseResult& result) {
  constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;
  text.heading(result.name);
  text.paragraph(result.what);
  if (!result.waits_for.empty()) return text.paragraph("Waits for the formulation " + result.waits_for + ": not run.");
  Table table{{{""}, {"run by", wrap}, {"measured", wrap}, {"limit", wrap}, {"value", right}}, {}};
  for (const CellResult& cell : result.cells) {
    std::vector<Cell> row{verdict_cell(cell), cell.owed ? cell.name : "(" + cell.name + ")"};
    const std::vector<Cell> measured = measured_cells(cell);
    row.insert(row.end(), measured.begin(), measured.end());
    if (row.back().text.size() > 12) table.columns.back().align = wrap;
    table.rows.push_back(std::move(row));
  }
  text.table(table);
}

std::string summary(const std::vector<CaseResult>& results) {
  std::size_t owed = 0, held = 0, shown = 0, shown_held = 0, waiting = 0;
  for (const CaseResult& result : results) {
    waiting += !result.waits_for.empty();
    for (const CellResult& cell : result.cells) {
      (cell.owed ? owed : shown) += 1;
      (cell.owed ? held : shown_held) += cell.held;
    }
  }
  std::string text = fmt::format("{}: {} of {} owed ways hold, and {} of {} that are shown for comparison",
                                 counted(results.size(), "case", "cases"), held, owed, shown_held, shown);
  if (waiting > 0) text += fmt::format("; {} waiting for what does not exist yet", waiting);
  return text + ".";
}

std::string text_of(const std::vector<CaseResult>& results) {
  Page text = page();
  for (const CaseResult& result : results) add_case(text, result);
  text.blank();
  text.paragraph(summary(results), 0);
  return text.text();
}

Json json_of(const CellResult& cell) {
  Json verdicts = Json::array();
  for (const Verdict& verdict : cell.verdicts) verdicts.push_back(scenes::json_of(verdict));
  return {{"name", cell.name},
          {"owed", cell.owed},
          {"held", cell.held},
          {"refused", cell.refused.empty() ? Json(nullptr) : Json(cell.refused)},
          {"reported", cell.reported.empty() ? Json(nullptr) : Json(cell.reported)},
          {"said", cell.said.empty() ? Json(nullptr) : Json(cell.said)},
          {"measures", cell.measures},
          {"seconds", cell.seconds},
          {"expectations", verdicts}};
}

// JSON has no NaN or infinity: they become null.
std::string json_of(const std::vector<CaseResult>& results, bool all_hold) {
  Json cases = Json::array();
  for (const CaseResult& result : results) {
    Json cells = Json::array();
    for (const CellResult& cell : result.cells) cells.push_back(json_of(cell));
    cases.push_back({{"name", result.name},
                     {"class", result.length},
                     {"what", result.what},
                     {"waits_for", result.waits_for.empty() ? Json(nullptr) : Json(result.waits_for)},
                     {"holds", result.waits_for.empty() ? Json(scenes::holds(result)) : Json(nullptr)},
                     {"cells", cells}});
  }
  const Json json{{"format", "ballpark-stress-1"}, {"holds", all_hold}, {"cases", cases}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Exit stress(const Arguments& arguments) {
  const std::vector<StressCase> cases = chosen_cases(arguments);
  if (arguments.json && !arguments.json->empty()) {
    for (const StressCase& one : cases) refuse_inputs({*arguments.json}, one.file());
  }
  Delivery delivery(arguments);
  watch_for_interrupt();
  const std::vector<CaseResult> results = results_of(cases, arguments);
  if (interrupted()) return interrupted_exit;
  const bool all_hold = std::all_of(results.begin(), results.end(), scenes::holds);
  delivery.text(text_of(results));
  delivery.json(json_of(results, all_hold));
  return all_hold ? done : check_failed;
}

}  // namespace ballpark::command
