#include "perf/cost/result_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace ballpark::cost {

namespace {

using Json = nlohmann::ordered_json;

Json positive(double value) {
  return value > 0 ? Json(value) : Json(nullptr);
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json contact_json(const ContactChoice& contact) {
  if (contact.kind.empty()) return nullptr;
  if (contact.kind == "penalty") return {{"kind", contact.kind}, {"stiffness", contact.stiffness}};
  return {{"kind", contact.kind}, {"iterations", contact.iterations}, {"substeps", contact.substeps}};
}

void add_setting(Json& json, const Setting& setting) {
  json["integrator"] = setting.integrator;
  json["step"] = positive(setting.step);
  json["tolerance"] = positive(setting.tolerance);
  json["precision"] = word(setting.precision);
  json["contact"] = contact_json(setting.contact);
  json["rotation"] = text_or_null(setting.rotation);
  json["opening_angle"] = setting.opening_angle < 0 ? Json(nullptr) : Json(setting.opening_angle);
}

Json by_quantity(const std::array<double, quantity_count>& values) {
  Json json;
  for (std::size_t q = 0; q < quantity_count; ++q) json[name(static_cast<Quantity>(q))] = values[q];
  return json;
}

/// Where the scene has events, and the run as many as the reference.
bool tells_event_times(const Point& point, const Result& result) {
  return !result.events.empty() && point.trouble.empty() && point.errors.events.different.empty();
}

/// Absolute, and over the reference's largest value of each quantity.
Json errors_json(const Point& point, const Result& result) {
  Json json;
  for (std::size_t q = 0; q < quantity_count; ++q) {
    const Distance& d = point.errors.of[q];
    const double scale = result.reference.scale[q];
    json[name(static_cast<Quantity>(q))] = {{"end", d.end},
                                            {"maximum", d.maximum},
                                            {"rms", d.rms},
                                            {"relative", scale > 0 ? Json(d.maximum / scale) : Json(nullptr)}};
  }
  json["energy"] = point.errors.energy;
  json["momentum"] = point.errors.momentum;
  json["angular_momentum"] = point.errors.angular_momentum;
  json["quaternion_norm"] = point.errors.quaternion_norm;
  json["penetration"] = point.errors.penetration;
  json["event_time"] = tells_event_times(point, result) ? Json(point.errors.events.time) : Json(nullptr);
  json["event_counts"] = text_or_null(point.errors.events.different);
  json["value"] = point.error;
  return json;
}

Json events_json(const Result& result) {
  Json events = Json::object();
  for (const scenes::EventTimes& event : result.events) {
    events[event.name] = {{"count", event.count}, {"times", event.times}};
  }
  return events;
}

Json seconds_json(const Seconds& seconds) {
  return {{"min", seconds.minimum}, {"median", seconds.median}, {"max", seconds.maximum}, {"runs", seconds.runs}};
}

Json point_json(const Point& point, const Result& result) {
  Json json;
  add_setting(json, point.setting);
  json["curve"] = point.curve;
  json["error"] = errors_json(point, result);
  json["claimed"] = point.claimed;
  json["pareto"] = point.front;
  json["seconds"] = seconds_json(point.seconds);
  json["steps"] = point.steps;
  json["rejected_steps"] = point.rejected_steps;
  json["force_evaluations"] = point.force_evaluations;
  json["state_hash"] = point.state_hash;
  json["trouble"] = text_or_null(point.trouble);
  return json;
}

Json recommended_json(const Result& result) {
  if (!result.recommended) return nullptr;
  const Recommendation& named = *result.recommended;
  const Point& point = result.points[named.point];
  Json json;
  json["point"] = named.point;
  add_setting(json, point.setting);
  json["error"] = point.error;
  json["seconds"] = point.seconds.minimum;
  json["limit"] = named.limit;
  json["margin"] = named.margin;
  json["confirmed_error"] = named.confirmed_error;
  json["sentence"] = named.sentence;
  return json;
}

Json curves_json(const Result& result) {
  Json list = Json::array();
  for (const Curve& curve : result.curves) {
    list.push_back({{"label", curve.label},
                    {"integrator", curve.integrator},
                    {"family", curve.family},
                    {"order", curve.order},
                    {"precision", word(curve.precision)},
                    {"points", curve.points}});
  }
  return list;
}

void add_mean(Json& json, const Observable& observable, const Mean& mean) {
  const double margin = mean.margin();
  json["observable"] = observable.name;
  json["unit"] = observable.unit;
  json["mean"] = mean.value;
  json["interval95"] = {mean.value - margin, mean.value + margin};
}

Json reference_json(const Ensemble& ensemble) {
  Json json, means = Json::array();
  for (std::size_t o = 0; o < ensemble.observables.size(); ++o) {
    add_mean(means.emplace_back(), ensemble.observables[o], ensemble.reference.means[o]);
  }
  add_setting(json, ensemble.reference.setting);
  json["why"] = ensemble.why_reference;
  json["seconds"] = ensemble.reference.seconds;
  json["means"] = means;
  return json;
}

Json ensemble_json(const Ensemble& ensemble) {
  Json observables = Json::array(), settings = Json::array();
  for (const Observable& o : ensemble.observables) observables.push_back({{"name", o.name}, {"unit", o.unit}});
  for (const EnsembleRuns& runs : ensemble.settings) {
    for (std::size_t o = 0; o < runs.means.size(); ++o) {
      Json& row = settings.emplace_back();
      const Difference& difference = runs.from_reference[o];
      add_setting(row, runs.setting);
      row["seconds"] = runs.seconds;
      add_mean(row, ensemble.observables[o], runs.means[o]);
      row["difference"] = difference.value;
      row["standard_error"] = difference.error;
      row["sigmas"] = difference.sigmas();
      row["chance"] = difference.chance;
    }
  }
  return {{"copies", ensemble.copies},  {"perturb", ensemble.perturb},
          {"time", ensemble.time},      {"reference", reference_json(ensemble)},
          {"observables", observables}, {"settings", settings}};
}

Json paths_json(const Result& result) {
  Json list = Json::array();
  for (const Path& path : result.paths) {
    list.push_back({{"label", path.label}, {"body", path.body}, {"points", path.points}});
  }
  return list;
}

/// Nothing stays nothing.
std::string quoted(std::string text) {
  if (text.empty()) return text;
  std::replace(text.begin(), text.end(), '"', '\'');
  return '"' + text + '"';
}

}  // namespace

const char* word(Precision precision) {
  return precision == Precision::single_ ? "single" : precision == Precision::double_ ? "double" : "extended";
}

Json to_json(const Result& result) {
  const Reference& reference = result.reference;
  Json json = {{"format", "ballpark-cost-1"}, {"scenario", result.scenario}, {"doc", result.doc},
               {"command", result.command},   {"machine", result.machine},   {"bodies", result.bodies},
               {"compared", result.compared}, {"duration", result.duration}, {"threads", result.threads}};
  json["measure"] = {{"quantity", name(result.quantity)},
                     {"which", result.which},
                     {"name", result.measure},
                     {"unit", result.measure_unit}};
  json["reference"] = {{"kind", reference.kind},
                       {"what", reference.what},
                       {"error_bar", by_quantity(reference.error_bar)},
                       {"scale", by_quantity(reference.scale)},
                       {"event_time", result.events.empty() ? Json(nullptr) : Json(reference.event_bar)},
                       {"events", events_json(result)},
                       {"floor", result.floor},
                       {"ceiling", result.ceiling}};
  json["remarks"] = result.remarks;
  json["horizon"] = nullptr;
  if (result.horizon) {
    json["horizon"] = {{"time", result.horizon->time},
                       {"lyapunov_time", result.horizon->lyapunov_time},
                       {"uncertainty", result.horizon->uncertainty},
                       {"sentence", result.horizon->sentence}};
  }
  json["ensemble"] = result.ensemble ? ensemble_json(*result.ensemble) : Json(nullptr);
  json["curves"] = curves_json(result);
  json["points"] = Json::array();
  for (const Point& point : result.points) json["points"].push_back(point_json(point, result));
  json["crossovers"] = result.crossovers;
  json["left_out"] = result.left_out;
  json["recommended"] = recommended_json(result);
  json["scene"] = nullptr;
  if (result.scene_setting) add_setting(json["scene"], *result.scene_setting);
  json["paths"] = paths_json(result);
  return json;
}

std::string to_csv(const Result& result) {
  std::string csv =
      "integrator,step,tolerance,precision,contact,iterations,substeps,stiffness,rotation,opening_angle,error,claimed,"
      "pareto,seconds_min,seconds_median,seconds_max,runs,steps,rejected_steps,force_evaluations";
  for (std::size_t q = 0; q < quantity_count; ++q) {
    const char* quantity = name(static_cast<Quantity>(q));
    csv += fmt::format(",{0}_end,{0}_maximum,{0}_rms", quantity);
  }
  csv += ",energy,momentum,angular_momentum,quaternion_norm,penetration,event_time,event_counts,state_hash,trouble\n";
  for (const Point& p : result.points) {
    const Setting& s = p.setting;
    const ContactChoice& c = s.contact;
    csv += fmt::format(
        "{},{:.17g},{:.17g},{},{},{},{},{:.17g},{},{},{:.17g},{:d},{:d},{:.9g},{:.9g},{:.9g},{},{},{},{}", s.integrator,
        s.step, s.tolerance, word(s.precision), c.kind, c.iterations, c.substeps, c.stiffness, s.rotation,
        s.opening_angle < 0 ? "" : fmt::format("{:g}", s.opening_angle), p.error, p.claimed, p.front, p.seconds.minimum,
        p.seconds.median, p.seconds.maximum, p.seconds.runs, p.steps, p.rejected_steps, p.force_evaluations);
    for (const Distance& d : p.errors.of) csv += fmt::format(",{:.17g},{:.17g},{:.17g}", d.end, d.maximum, d.rms);
    const Errors& e = p.errors;
    const std::string event_time = tells_event_times(p, result) ? fmt::format("{:.9g}", e.events.time) : "";
    csv += fmt::format(",{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{},{},{}\n", e.energy, e.momentum, e.angular_momentum,
                       e.quaternion_norm, e.penetration, event_time, quoted(e.events.different), p.state_hash,
                       quoted(p.trouble));
  }
  return csv;
}

}  // namespace ballpark::cost
