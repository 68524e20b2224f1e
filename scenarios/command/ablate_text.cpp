#include "scenarios/command/ablate_text.h"

#include <fmt/format.h>

#include <cmath>

#include "scenarios/command/cost_text.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

using cost::Ablation;
using cost::Beside;
using cost::Change;
using cost::Loss;

constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;

/// Of the time, by minima and by medians.
std::string saved_text(const Beside& time) {
  const std::string text =
      fmt::format("{:.1f} / {:.1f} %", 100 * time.saved_of_minima(), 100 * time.saved_of_medians());
  return time.shows() ? text : "(" + text + ")";
}

/// "3.1", "< 2e-09" where no more is claimed.
std::string size_text(double size, double claimed) {
  if (!std::isfinite(size)) return "gone";
  return size > claimed ? fmt::format("{:.3g}", size) : fmt::format("< {:.1e}", claimed);
}

std::string value_text(const cost::Observation& seen) {
  if (!seen.there) return "none";
  if (seen.value.y() == 0 && seen.value.z() == 0) return number(seen.value.x(), 8);
  const auto rounded = [&](double x) { return std::abs(x) > 1e-9 * seen.value.norm() ? number(x, 4) : "0"; };
  return joined({rounded(seen.value.x()), rounded(seen.value.y()), rounded(seen.value.z())}, " ");
}

void add_losses(Page& page, const Ablation& ablation) {
  page.heading("Without each effect, the cheapest to lose first");
  Table table{{{"without", wrap},
               {"time saved", right},
               {fmt::format("{} [{}]", name(ablation.about.quantity), ablation.about.measure_unit), right},
               {"energy [J]", right},
               {"B", right},
               {"flops", right},
               {""}},
              {}};
  for (const Loss& loss : ablation.losses) {
    if (!loss.trouble.empty()) {
      table.rows.push_back({loss.label, "-", "-", "-", "-", "-", Cell("keep", Style::bad)});
      continue;
    }
    table.rows.push_back({Cell(loss.label, Style::strong), saved_text(loss.time),
                          size_text(loss.moved, ablation.own_error), size_text(loss.energy.size, loss.energy.own_error),
                          number(loss.bytes, 4), number(loss.flops, 4),
                          loss.keep ? Cell("keep", Style::bad) : Cell("may go", Style::good)});
  }
  page.table(table);
  page.paragraph(
      "Time saved: of the whole run, by least and median times; in parentheses: runs of the full scene alone differ "
      "as much. B, flops: a body-step moves and computes less.");
  std::vector<std::string> sentences;
  for (const Loss& loss : ablation.losses) sentences.push_back(loss.sentence);
  page.list(sentences);
}

/// What the scene is judged and watched by, where it changes.
void add_own(Page& page, const Ablation& ablation) {
  Table table{{{"without", wrap}, {"quantity", wrap}, {"full scene", right}, {"without it", right}, {"apart", right}},
              {}};
  for (const Loss& loss : ablation.losses) {
    for (const Change& change : loss.own) {
      if (!change.seen()) continue;
      const std::string unit = change.unit.empty() ? "" : " [" + change.unit + "]";
      table.rows.push_back({loss.label, change.name + unit, value_text(change.full),
                            Cell(value_text(change.without), change.breaks() ? Style::bad : Style::plain),
                            size_text(change.size, change.own_error)});
    }
  }
  if (table.rows.empty()) return;
  page.heading("What the scene expects and watches, where it changes");
  page.table(table);
}

void add_means(Page& page, const Ablation& ablation) {
  if (ablation.copies == 0) return;
  page.heading(fmt::format("Beyond the horizon: means of {} runs with each effect and without", ablation.copies));
  page.paragraph(fmt::format(
      "Starts differ by a relative {:g}, and by what the scene's seed draws. Shown is what changes so clearly that "
      "chance does it for one of twenty effects without influence; intervals of 95 % by Student's t.",
      ablation.perturb));
  Table table{{{"without", wrap}, {"mean", wrap}, {"full scene", right}, {"without it", right}, {"sigma", right}}, {}};
  for (const Loss& loss : ablation.losses) {
    for (const cost::MeanChange& mean : loss.means) {
      if (!mean.seen) continue;
      table.rows.push_back({loss.label, mean.observable.name, mean_text(mean.full, mean.observable),
                            mean_text(mean.without, mean.observable), number(mean.difference.sigmas(), 3)});
    }
  }
  table.rows.empty() ? page.paragraph("No mean changes.") : page.table(table);
}

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json value_json(const cost::Observation& seen) {
  if (!seen.there) return nullptr;
  if (!seen.name.starts_with("place of ")) return seen.value.x();
  return {seen.value.x(), seen.value.y(), seen.value.z()};
}

Json change_json(const Change& change) {
  return {{"quantity", change.name},
          {"unit", change.unit},
          {"full", value_json(change.full)},
          {"without", value_json(change.without)},
          {"change", number_or_null(change.size)},
          {"own_error", number_or_null(change.own_error)},
          {"claimed", change.seen()},
          {"missed", change.breaks()}};
}

Json seconds_json(const cost::Seconds& seconds) {
  return {{"min", seconds.minimum}, {"median", seconds.median}, {"max", seconds.maximum}, {"runs", seconds.runs}};
}

Json time_json(const Beside& time) {
  return {{"full", seconds_json(time.base)},
          {"without", seconds_json(time.seconds)},
          {"saved", {{"min", time.saved_of_minima()}, {"median", time.saved_of_medians()}}},
          {"noise", time.noise},
          {"shows", time.shows()}};
}

Json means_json(const Loss& loss) {
  Json list = Json::array();
  for (const cost::MeanChange& mean : loss.means) {
    list.push_back({{"observable", mean.observable.name},
                    {"unit", mean.observable.unit},
                    {"full", {{"mean", mean.full.value}, {"standard_error", mean.full.error}}},
                    {"without", {{"mean", mean.without.value}, {"standard_error", mean.without.error}}},
                    {"difference", mean.difference.value},
                    {"chance", mean.difference.chance},
                    {"seen", mean.seen}});
  }
  return list;
}

Json loss_json(const Ablation& ablation, const Loss& loss) {
  Json json{{"effect", loss.kind}, {"index", loss.index}};
  json["trouble"] = loss.trouble.empty() ? Json(nullptr) : Json(loss.trouble);
  json["verdict"] = loss.keep ? "keep" : "may go";
  json["sentence"] = loss.sentence;
  if (!loss.trouble.empty()) return json;
  json["time"] = time_json(loss.time);
  json["bytes_per_body_step"] = loss.bytes;
  json["flops_per_body_step"] = loss.flops;
  Json& error = json["error"];
  for (std::size_t q = 0; q < cost::quantity_count; ++q) {
    const cost::Distance& distance = loss.errors.of[q];
    error[name(static_cast<cost::Quantity>(q))] = {{"end", distance.end}, {"maximum", distance.maximum}};
  }
  error["value"] = loss.moved;
  error["claimed"] = loss.moved > ablation.own_error;
  error["same_bits"] = loss.same_bits;
  json["energy"] = change_json(loss.energy);
  json["observables"] = Json::array();
  for (const Change& change : loss.own) json["observables"].push_back(change_json(change));
  json["means"] = means_json(loss);
  return json;
}

}  // namespace

std::string ablation_text(const Ablation& ablation) {
  Page text = page();
  const cost::Result& about = ablation.about;
  text.heading(about.scenario);
  add_ground(text, about);
  text.fields({{"scene's error", fmt::format("{:.1e} {}, of its integrator and step: no smaller change is claimed",
                                             ablation.own_error, about.measure_unit)},
               {"worth losing",
                fmt::format("an effect whose loss changes at most {:.3g} {}", ablation.most, about.measure_unit)}});
  if (ablation.losses.empty()) text.paragraph("The scene has no effects.");
  if (!ablation.losses.empty()) add_losses(text, ablation);
  add_own(text, ablation);
  add_means(text, ablation);
  if (!about.left_out.empty()) text.heading("Left out");
  text.list(about.left_out);
  return text.text();
}

Json ablation_json(const Ablation& ablation) {
  const cost::Result& about = ablation.about;
  Json effects = Json::array();
  for (const Loss& loss : ablation.losses) effects.push_back(loss_json(ablation, loss));
  Json json{{"format", "ballpark-ablate-1"},
            {"scenario", about.scenario},
            {"machine", about.machine},
            {"threads", about.threads},
            {"bodies", about.bodies},
            {"duration", about.duration},
            {"measure", about.measure},
            {"unit", about.measure_unit},
            {"reference", {{"kind", about.reference.kind}, {"what", about.reference.what}, {"floor", about.floor}}},
            {"own_error", ablation.own_error},
            {"tolerance", ablation.most}};
  json["horizon"] = nullptr;
  if (about.horizon) {
    json["horizon"] = {{"time", about.horizon->time},
                       {"lyapunov_time", about.horizon->lyapunov_time},
                       {"sentence", about.horizon->sentence}};
  }
  json["ensembles"] = nullptr;
  if (ablation.copies > 0) json["ensembles"] = {{"copies", ablation.copies}, {"perturb", ablation.perturb}};
  json["effects"] = effects;
  json["left_out"] = about.left_out;
  return json;
}

}  // namespace ballpark::command
