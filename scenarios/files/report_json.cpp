#include "scenarios/files/report_json.h"

namespace ballpark::scenes {

namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Body, step and time of the first thing that went wrong; null while nothing did.
Json json_of(const Status& status) {
  Json json = {{"code", name(status.code)}, {"sentence", status.sentence}};
  const bool ok = status.code == Status::Code::ok;
  json["body"] = ok ? Json(nullptr) : Json(status.body);
  json["step"] = ok ? Json(nullptr) : Json(status.step);
  json["time"] = ok ? Json(nullptr) : Json(status.time);
  return json;
}

Json verdicts_of(const RunReport& report) {
  Json list = Json::array();
  for (const Verdict& verdict : report.verdicts) list.push_back(json_of(verdict));
  return list;
}

Json events_of(const RunReport& report) {
  Json events = Json::object();
  for (const EventTimes& event : report.events) events[event.name] = {{"count", event.count}, {"times", event.times}};
  return events;
}

Json json_of(const Ledger::Kinetic& kinetic) {
  return {{"translation", kinetic.translation}, {"rotation", kinetic.rotation}};
}

/// Lines by name: no two have the same.
Json json_of(const std::optional<Ledger>& ledger) {
  if (!ledger) return nullptr;
  Json lines = Json::object();
  for (const LedgerLine& line : ledger->lines) {
    Json& of = lines[line.name];
    of["work"] = line.work;
    of["potential"] = line.has_energy ? Json({{"initial", line.initial}, {"final", line.final}}) : Json(nullptr);
    of["gain"] = line.has_energy ? Json(line.gain()) : Json(line.work);
  }
  return {{"from", ledger->from},
          {"to", ledger->to},
          {"kinetic", {{"initial", json_of(ledger->initial)}, {"final", json_of(ledger->final)}}},
          {"lines", lines},
          {"integrator_error", ledger->integrator_error()}};
}

}  // namespace

Json json_of(const Verdict& verdict) {
  const Expectation& wanted = verdict.expectation;
  return {{"quantity", wanted.quantity},
          {"at", verdict.time},
          {"measured", verdict.measured},
          {"min", or_null(wanted.minimum)},
          {"max", or_null(wanted.maximum)},
          {"value", or_null(wanted.value)},
          {"tolerance", or_null(wanted.tolerance)},
          {"met", verdict.met},
          {"sentence", verdict.sentence}};
}

Json json_of(const RunReport& report) {
  const bool implicit = report.path == "implicit" || report.counters.newton_iterations > 0;
  return {{"format", "ballpark-run-1"},
          {"scenario", report.scenario},
          {"status", json_of(report.status)},
          {"bodies", report.bodies},
          {"time", report.time},
          {"steps", report.counters.steps},
          {"rejected_steps", report.counters.rejected_steps},
          {"force_evaluations", report.counters.force_evaluations},
          {"pairs", report.counters.pairs},
          {"contacts", report.counters.contacts},
          {"peak_pairs", report.counters.peak_pairs},
          {"peak_contacts", report.counters.peak_contacts},
          {"max_penetration", report.counters.max_penetration},
          {"impacts",
           {{"count", report.counters.impacts},
            {"most_rounds", report.counters.impact_rounds},
            {"unfinished", report.counters.unfinished_impacts}}},
          {"solver",
           {{"colours", report.counters.colours},
            {"residual", report.counters.residual},
            {"held_back", report.counters.held_back},
            {"missed", report.counters.missed},
            {"neighbour_lists", report.counters.neighbour_lists},
            {"largest_step", report.largest_step}}},
          {"newton_iterations", implicit ? Json(report.counters.newton_iterations) : Json(nullptr)},
          {"newton_residual", implicit ? Json(report.counters.newton_residual) : Json(nullptr)},
          {"contact", report.contact.empty() ? Json(nullptr) : Json(report.contact)},
          {"integrator", report.integrator},
          {"step", report.tolerance > 0 ? Json(nullptr) : Json(report.step)},
          {"tolerance", report.tolerance > 0 ? Json(report.tolerance) : Json(nullptr)},
          {"wall_seconds", report.wall_seconds},
          {"body_steps_per_second", report.body_steps_per_second},
          {"threads", report.threads},
          {"precision", report.precision},
          {"target", report.target},
          {"path", report.path},
          {"state_hash", report.state_hash},
          {"energy",
           {{"initial", report.initial.energy()},
            {"final", report.final.energy()},
            {"drift_relative", report.energy_drift_relative},
            {"kinetic", report.final.kinetic},
            {"potential", report.final.potential}}},
          {"momentum", {{"drift", report.momentum_drift}}},
          {"angular_momentum", {{"drift", report.angular_momentum_drift}}},
          {"present_bodies", report.bodies - report.final.absent_bodies},
          {"entered_bodies", report.counters.entered},
          {"left_bodies", report.counters.left},
          {"non_finite_bodies", report.final.non_finite_bodies},
          {"bodies_outside", report.final.bodies_outside},
          {"events", events_of(report)},
          {"ledger", json_of(report.ledger)},
          {"warnings", report.warnings},
          {"expectations", verdicts_of(report)}};
}

// JSON has no NaN or infinity: they become null.
std::string to_json(const RunReport& report) {
  return json_of(report).dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ballpark::scenes
