#include "perf/throughput/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace ballpark::perf {

namespace {

using Text = fmt::memory_buffer;

template <class... Args>
void add(Text& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

struct Times {
  double minimum, median, maximum;  // ns per unit
};

Times times_of(const Row& row) {
  return {row.nanoseconds(row.samples.minimum()), row.nanoseconds(row.samples.median()),
          row.nanoseconds(row.samples.maximum())};
}

template <class Key>
auto distinct(const std::vector<Row>& rows, Key key) {
  std::vector<std::decay_t<decltype(key(rows.front()))>> values;
  for (const Row& row : rows) {
    if (std::find(values.begin(), values.end(), key(row)) == values.end()) values.push_back(key(row));
  }
  return values;
}

const Row& row_at(const std::vector<Row>& rows, const std::string& name, std::size_t bodies) {
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const Row& row) { return row.name == name && row.bodies == bodies; });
}

std::string describe(const Bar& bar) {
  return fmt::format("{} {}{}", bar.at_most ? "<=" : ">=", bar.limit,
                     bar.aim ? fmt::format(" (aim {})", *bar.aim) : "");
}

// One size: a row a line, with all there is to say of it.
void add_list(Text& text, const Result& result) {
  add(text, "{:<28}{:>10}{:>10}{:>10}{:>8}{:>8}   ns per body-step; GB/s at the minimum\n", "", "minimum", "median",
      "maximum", "bytes", "GB/s");
  for (const Row& row : result.rows) {
    const Times t = times_of(row);
    add(text, "{:<28}{:>10.2f}{:>10.2f}{:>10.2f}{:>8.0f}{:>8.1f}\n", row.name, t.minimum, t.median, t.maximum,
        row.bytes_per_unit, row.bytes_per_unit / t.minimum);
  }
}

// Several sizes: one a column.
void add_table(Text& text, const Result& result) {
  const auto names = distinct(result.rows, [](const Row& row) { return row.name; });
  const auto sizes = distinct(result.rows, [](const Row& row) { return row.bodies; });
  add(text, "{:<28}", "minimum / median ns");
  for (const std::size_t bodies : sizes) add(text, "{:>24}", fmt::format("{} bodies", bodies));
  add(text, "\n");
  for (const std::string& name : names) {
    add(text, "{:<28}", name);
    for (const std::size_t bodies : sizes) {
      const Times t = times_of(row_at(result.rows, name, bodies));
      std::string cell = fmt::format("{:.2f} / {:.2f}", t.minimum, t.median);
      if (!result.base.empty() && name != result.base) {
        cell += fmt::format(" ({:+.2f})", t.minimum - times_of(row_at(result.rows, result.base, bodies)).minimum);
      }
      add(text, "{:>24}", cell);
    }
    add(text, "\n");
  }
}

void add_ratios(Text& text, const std::vector<RatioResult>& ratios) {
  if (ratios.empty()) return;
  add(text, "\n{:<34}{:>12}{:>12}   {}\n", "ratio", "of minima", "of medians", "bar");
  for (const RatioResult& r : ratios) {
    const std::string bar = r.ratio.bar ? fmt::format("{}: {}", describe(*r.ratio.bar), r.met ? "met" : "MISSED") : "";
    add(text, "{:<34}{:>12.3f}{:>12.3f}   {}\n", r.ratio.name, r.of_minima, r.of_medians, bar);
  }
}

void add_agreements(Text& text, const std::vector<AgreementResult>& agreements) {
  if (agreements.empty()) return;
  add(text, "\nsame result (largest difference over largest value)\n");
  for (const AgreementResult& a : agreements) {
    add(text, "{:<34}{:>12.2g}   {}: {}\n", fmt::format("{} = {}", a.agreement.a, a.agreement.b), a.error,
        a.agreement.tolerance == 0 ? "equal bits" : fmt::format("<= {:g}", a.agreement.tolerance),
        a.met ? "met" : "MISSED");
  }
}

nlohmann::json json_of(const Row& row) {
  const Times t = times_of(row);
  return {{"name", row.name},
          {"bodies", row.bodies},
          {"nanoseconds", {{"minimum", t.minimum}, {"median", t.median}, {"maximum", t.maximum}}},
          {"bytes", row.bytes_per_unit},
          {"gigabytes_per_second", row.bytes_per_unit / t.minimum},
          {"rounds", row.samples.count()}};
}

nlohmann::json json_of(const RatioResult& r) {
  nlohmann::json json = {{"name", r.ratio.name}, {"of_minima", r.of_minima}, {"of_medians", r.of_medians}};
  if (r.ratio.bar) {
    json[r.ratio.bar->at_most ? "at_most" : "at_least"] = r.ratio.bar->limit;
    if (r.ratio.bar->aim) json["aim"] = *r.ratio.bar->aim;
    json["met"] = r.met;
  }
  return json;
}

nlohmann::json json_of(const AgreementResult& a) {
  return {{"a", a.agreement.a},
          {"b", a.agreement.b},
          {"error", a.error},
          {"tolerance", a.agreement.tolerance},
          {"met", a.met}};
}

template <class Item>
nlohmann::json json_list(const std::vector<Item>& items) {
  nlohmann::json list = nlohmann::json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

}  // namespace

std::string heading(const Machine& machine, const Settings& settings) {
  Text text;
  add(text, "{}, {} threads at once, L2 {} KiB, L3 {} KiB; {}; load {:.2f}\n", machine.processor, machine.threads,
      machine.level2_bytes / 1024, machine.level3_bytes / 1024, machine.compiler, machine.load);
  add(text,
      "Threads are not pinned. Subjects run in turns, at least {:g} s and 9 rounds each comparison.\n"
      "Bars are judged on the minima, which other programs disturb least.\n",
      settings.seconds);
  return fmt::to_string(text);
}

std::string to_text(const Result& result) {
  Text text;
  add(text, "\n{}\n{} ({} rounds)\n\n", result.title, result.note, result.rows.front().samples.count());
  result.by_size ? add_table(text, result) : add_list(text, result);
  add_ratios(text, result.ratios);
  add_agreements(text, result.agreements);
  return fmt::to_string(text);
}

std::string to_json(const Machine& machine, const Settings& settings, const std::vector<Result>& results) {
  nlohmann::json comparisons = nlohmann::json::array();
  for (const Result& result : results) {
    comparisons.push_back({{"title", result.title},
                           {"note", result.note},
                           {"rows", json_list(result.rows)},
                           {"ratios", json_list(result.ratios)},
                           {"agreements", json_list(result.agreements)}});
  }
  const nlohmann::json json = {{"format", 1},
                               {"machine",
                                {{"processor", machine.processor},
                                 {"threads", machine.threads},
                                 {"level2_bytes", machine.level2_bytes},
                                 {"level3_bytes", machine.level3_bytes},
                                 {"memory_bytes", machine.memory_bytes},
                                 {"compiler", machine.compiler},
                                 {"load", machine.load}}},
                               {"version", version()},
                               {"bodies", settings.bodies},
                               {"threads", settings.threads},
                               {"seconds", settings.seconds},
                               {"comparisons", comparisons}};
  return json.dump(2) + "\n";
}

}  // namespace ballpark::perf
