// ballpark prices: what each effect adds to the time of a step.
#include "perf/effects/prices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/result_json.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

using cost::EffectPrice;
using cost::Price;
using cost::word;

constexpr Column::Align right = Column::Align::right;

/// "0.31 / 0.33", least and median; in parentheses what is within noise.
std::string price_text(const Price* price) {
  if (!price) return "-";
  const auto digits = [](double x) { return std::abs(x) < 9.95 ? 2 : std::abs(x) < 99.5 ? 1 : 0; };
  const double least = price->nanoseconds_of_minima, median = price->nanoseconds_of_medians;
  const std::string text = fmt::format("{:.{}f} / {:.{}f}", least, digits(least), median, digits(median));
  return price->shows ? text : "(" + text + ")";
}

const Price* price_at(const EffectPrice& effect, Precision precision, bool many) {
  const Price* found = nullptr;
  for (const Price& price : effect.prices) {
    if (price.precision != precision) continue;
    if (!found || (many ? price.bodies > found->bodies : price.bodies < found->bodies)) found = &price;
  }
  return found;
}

std::vector<Precision> precisions_of(const std::vector<EffectPrice>& list) {
  std::vector<Precision> all;
  for (const EffectPrice& effect : list) {
    for (const Price& price : effect.prices) {
      if (std::find(all.begin(), all.end(), price.precision) == all.end()) all.push_back(price.precision);
    }
  }
  return all;
}

/// The most that any effect was timed with, as many or as few bodies.
std::size_t bodies_of(const std::vector<EffectPrice>& list, bool many) {
  std::size_t bodies = 0;
  for (const EffectPrice& effect : list) {
    const Price* price = price_at(effect, effect.prices.front().precision, many);
    bodies = std::max(bodies, price->bodies);
  }
  return bodies;
}

/// Where an effect took fewer.
std::string fewer_text(const Price* price, std::size_t bodies) {
  return price && price->bodies < bodies ? grouped(price->bodies) + ": " : "";
}

void add_alone(Page& page, const cost::Prices& prices) {
  for (const Precision precision : precisions_of(prices.alone)) {
    page.heading(
        fmt::format("Alone, {}: ns that an effect adds to a body-step of {}", word(precision), prices.integrator));
    const std::size_t many = bodies_of(prices.alone, true), few = bodies_of(prices.alone, false);
    Table table{{{"effect"}, {"beside"}, {"flops", right}, {"B", right}, {grouped(many) + " bodies", right}}, {}};
    if (few < many) table.columns.push_back({grouped(few) + " bodies", right});
    for (const EffectPrice& effect : prices.alone) {
      const Price *large = price_at(effect, precision, true), *small = price_at(effect, precision, false);
      table.rows.push_back({Cell(effect.label, Style::strong), effect.beside,
                            fmt::format("{:.0f}", effect.flops_of_step), fmt::format("{:.0f}", effect.bytes),
                            fewer_text(large, many) + price_text(large)});
      const bool told = small == large;  // it was timed with few bodies only
      if (few < many) table.rows.back().emplace_back(told ? "-" : fewer_text(small, few) + price_text(small));
    }
    page.table(table);
  }
}

void add_in_scene(Page& page, const cost::Prices& prices) {
  if (prices.in_scene.empty()) return;
  page.heading(fmt::format("In {}: ns of a body-step that go with an effect", prices.in_scene.front().beside));
  if (prices.duration < prices.whole * (1 - 1e-9)) {
    page.paragraph(fmt::format("Timed over the first {} of {} s.", number(prices.duration, 4), number(prices.whole)));
  }
  const std::vector<Precision> precisions = precisions_of(prices.in_scene);
  Table table{{{"effect"}, {"flops", right}, {"B", right}}, {}};
  for (const Precision precision : precisions) {
    table.columns.push_back({word(precision), right});
    table.columns.push_back({"of", right});
  }
  for (const EffectPrice& effect : prices.in_scene) {
    std::vector<Cell> cells{Cell(effect.label, Style::strong), number(effect.flops_of_step, 4),
                            number(effect.bytes, 4)};
    for (const Precision precision : precisions) {
      const Price* price = price_at(effect, precision, true);
      cells.emplace_back(price_text(price));
      cells.emplace_back(price ? number(price->base + price->nanoseconds_of_minima, 4) : "-");
    }
    table.rows.push_back(std::move(cells));
  }
  page.table(table);
}

std::string prices_text(const cost::Prices& prices) {
  Page text = page();
  text.heading("What effects add to a step");
  text.fields({{"machine", fmt::format("{}, {}", prices.machine,
                                       counted(static_cast<std::uint64_t>(prices.threads), "thread", "threads"))}});
  add_alone(text, prices);
  add_in_scene(text, prices);
  text.paragraph(
      "Least and median of runs in turns with runs without the effect; in parentheses: runs without it alone differ as "
      "much. flops, B: a body-step computes and moves more.");
  if (!prices.left_out.empty()) text.heading("Left out");
  text.list(prices.left_out);
  return text.text();
}

Json list_json(const std::vector<EffectPrice>& list) {
  Json effects = Json::array();
  for (const EffectPrice& effect : list) {
    Json prices = Json::array();
    for (const Price& price : effect.prices) {
      prices.push_back(
          {{"precision", word(price.precision)},
           {"bodies", price.bodies},
           {"ns_per_body_step",
            {{"min", price.nanoseconds_of_minima}, {"median", price.nanoseconds_of_medians}, {"without", price.base}}},
           {"shows", price.shows}});
    }
    effects.push_back({{"effect", effect.label},
                       {"beside", effect.beside},
                       {"flops_per_evaluation", effect.flops},
                       {"flops_per_body_step", effect.flops_of_step},
                       {"bytes_per_body_step", effect.bytes},
                       {"prices", prices}});
  }
  return effects;
}

Json prices_json(const cost::Prices& prices) {
  Json json{{"format", "ballpark-prices-1"},   {"machine", prices.machine},        {"threads", prices.threads},
            {"integrator", prices.integrator}, {"alone", list_json(prices.alone)}, {"in_scene", nullptr},
            {"left_out", prices.left_out}};
  if (!prices.in_scene.empty()) json["in_scene"] = list_json(prices.in_scene);
  return json;
}

cost::PricesRequest request_of(const Arguments& arguments) {
  constexpr std::uint64_t most_bodies = 1'000'000'000;
  cost::PricesRequest request;
  request.options = run_options(arguments);
  if (arguments.copies || arguments.perturb) throw UsageError("--copies, --perturb: prices runs one copy of a scene");
  if (arguments.bodies) request.bodies = whole_number("--bodies", *arguments.bodies, 2, most_bodies);
  if (arguments.seconds) request.seconds = real_number("--seconds", *arguments.seconds, false);
  Scene plain;
  plain.bodies.emplace_back().mass.resize(1);
  plain.bodies[0].generate = Generate{.kind = "random", .count = {4 * request.bodies}};  // in turns with others
  check_memory(plain, request.options);
  return request;
}

}  // namespace

Exit prices_of_effects(const Arguments& arguments) {
  cost::PricesRequest request = request_of(arguments);
  if (arguments.name.empty() && !arguments.overrides.empty()) {
    throw UsageError("--set: there is no scene; expected one before its options");
  }
  if (!arguments.name.empty()) {
    const scenes::SceneFile file = load_scene(arguments);
    check_memory(file.scene, request.options);
    if (!(file.scene.run.duration > 0)) throw UsageError("run.duration is 0: there is no step to time");
    if (body_count(file.scene) == 0) throw UsageError("the scene has no bodies: there is no step to time");
    request.scene = file.scene;
  }
  Delivery delivery(arguments);
  watch_for_interrupt();
  std::optional<cost::Prices> prices;
  {
    Progress progress("timing", !arguments.quiet);
    prices = cost::prices(request, [&](const std::string&, double fraction) {
      progress.show(fraction);
      return !interrupted();
    });
  }
  if (!prices || interrupted()) return interrupted_exit;
  delivery.text(prices_text(*prices));
  delivery.json(prices_json(*prices).dump(2));
  return done;
}

}  // namespace ballpark::command
