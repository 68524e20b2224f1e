#include "scenarios/command/catalogue_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

std::string toml(double x) {
  const std::string text = fmt::format("{}", x);
  return text.find_first_of(".eni") == std::string::npos ? text + ".0" : text;  // "inf" and "nan" are TOML too
}

std::string toml(const Vector3d& v) {
  return fmt::format("[{}, {}, {}]", toml(v.x()), toml(v.y()), toml(v.z()));
}

Json json(double x) {
  return std::isfinite(x) ? Json(x) : Json(fmt::format("{}", x));
}

Json json(const Vector3d& v) {
  return Json::array({json(v.x()), json(v.y()), json(v.z())});
}

std::string toml(const IdPair& pair) {
  return fmt::format("[{}, {}]", pair[0], pair[1]);
}

template <class T>
std::string toml(const std::vector<T>& list) {
  std::vector<std::string> rows;
  for (const T& row : list) rows.push_back(toml(row));
  return '[' + joined(rows) + ']';
}

Json json(const IdPair& pair) {
  return Json::array({pair[0], pair[1]});
}

struct ValueJson {
  Json operator()(double x) const { return json(x); }
  Json operator()(const Vector3d& v) const { return json(v); }
  template <class T>
  Json operator()(const std::vector<T>& rows) const {
    Json list = Json::array();
    for (const T& row : rows) list.push_back(json(row));
    return list;
  }
  Json operator()(const std::string& word) const { return word; }
};

Json to_json(const ParameterInfo& parameter) {
  Json object{{"name", parameter.name}, {"kind", kind_name(parameter.kind)}, {"unit", parameter.unit}};
  object["required"] = !parameter.fallback;
  if (parameter.fallback) object["default"] = std::visit(ValueJson{}, *parameter.fallback);
  if (std::isfinite(parameter.minimum)) object["minimum"] = parameter.minimum;
  if (std::isfinite(parameter.maximum)) object["maximum"] = parameter.maximum;
  if (!parameter.choices.empty()) object["choices"] = parameter.choices;
  object["doc"] = parameter.doc;
  return object;
}

/// Something valid for a parameter that has no default.
Value plausible(const ParameterInfo& parameter) {
  switch (parameter.kind) {
    case ParameterKind::number:
    case ParameterKind::numbers:
      return std::clamp(parameter.unit == "s" ? 1.0 : 0.1, parameter.minimum, parameter.maximum);
    case ParameterKind::vector:
      return parameter.name == "size" ? Vector3d(1, 1, 1) : Vector3d(0, 0, 1);
    case ParameterKind::vectors:
      return std::vector<Vector3d>{Vector3d(0, 0, 1)};
    case ParameterKind::pairs:
      return std::vector<IdPair>{{0, 1}};
    case ParameterKind::word:
      break;
  }
  return parameter.choices.front();
}

}  // namespace

std::string kind_name(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return "number";
    case ParameterKind::vector:
      return "vector";
    case ParameterKind::vectors:
      return "vector(s)";
    case ParameterKind::numbers:
      return "number(s)";
    case ParameterKind::pairs:
      return "pairs";
    case ParameterKind::word:
      break;
  }
  return "word";
}

std::string toml(const Value& value) {
  if (const std::string* word = std::get_if<std::string>(&value)) return '"' + *word + '"';
  return std::visit(
      [](const auto& v) {
        if constexpr (std::is_same_v<decltype(v), const std::string&>)
          return v;
        else
          return toml(v);
      },
      value);
}

std::string example(const EffectDescription& effect) {
  std::string text = fmt::format("[[effects]]\nkind = \"{}\"\n", effect.name);
  for (const ParameterInfo& parameter : effect.parameters) {
    const std::string value = toml(parameter.fallback ? *parameter.fallback : plausible(parameter));
    const std::string what = parameter.unit.empty() ? range(parameter) : parameter.unit;
    text +=
        fmt::format("{:<36}  # {}\n", parameter.name + " = " + value, what + (parameter.fallback ? " (default)" : ""));
  }
  return text;
}

std::string range(const ParameterInfo& parameter) {
  if (!parameter.choices.empty()) return fmt::format("\"{}\"", fmt::join(parameter.choices, "\" | \""));
  const bool below = std::isfinite(parameter.minimum), above = std::isfinite(parameter.maximum);
  if (below && above) return fmt::format("{} to {}", parameter.minimum, parameter.maximum);
  if (below) return fmt::format(">= {}", parameter.minimum);
  return above ? fmt::format("<= {}", parameter.maximum) : "";
}

Json to_json(const EffectDescription& effect) {
  Json parameters = Json::array();
  for (const ParameterInfo& parameter : effect.parameters) parameters.push_back(to_json(parameter));
  return {{"name", effect.name},
          {"doc", effect.doc},
          {"parameters", parameters},
          {"reads", effect.reads},
          {"exerts", effect.exerts},
          {"energy", effect.has_energy},
          {"force_derivative", effect.has_force_derivative},
          {"flops", effect.flops},
          {"source", effect.source}};
}

/// A limit that there is not: null.
Json finite_or_null(double limit) {
  return std::isfinite(limit) ? Json(limit) : Json(nullptr);
}

Json to_json(const IntegratorDescription& integrator) {
  return {{"name", integrator.name},
          {"doc", integrator.doc},
          {"family", integrator.family},
          {"order", integrator.order},
          {"evaluations", integrator.evaluations},
          {"symplectic", integrator.symplectic},
          {"turns_velocity", integrator.turns_velocity},
          {"implicit", integrator.implicit},
          {"real_limit", finite_or_null(integrator.real_limit)},
          {"imaginary_limit", finite_or_null(integrator.imaginary_limit)},
          {"source", integrator.source}};
}

Json to_json(const NamedDescription& entry) {
  return {{"name", entry.name}, {"doc", entry.doc}};
}

}  // namespace ballpark::command
