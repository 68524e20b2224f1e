#include "scenarios/command/cost_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "ballpark/catalogue.h"
#include "perf/cost/ensemble.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at; (at = text.find(separator, begin)) != std::string::npos; begin = at + 1) {
    parts.push_back(text.substr(begin, at - begin));
  }
  parts.push_back(text.substr(begin));
  return parts;
}

/// What a list on the command line may hold.
std::vector<std::string> words_of(const std::string& option, const std::string& text, const char* what,
                                  const std::vector<std::string>& names) {
  std::vector<std::string> words;
  for (const std::string& word : split(text, ',')) {
    if (std::find(names.begin(), names.end(), word) == names.end()) {
      throw UsageError(option + ": " + no_such(what, word, names));
    }
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words;
}

/// From coarse to fine.
std::vector<double> numbers_of(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : split(text, ',')) numbers.push_back(real_number(option, word, false));
  std::sort(numbers.begin(), numbers.end(), std::greater<>());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// "impulse", "penalty", "12x4": impulse contacts of so many iterations x substeps, "penalty:1e6": of that stiffness.
cost::ContactChoice contact_of(const std::string& word) {
  if (word == "impulse" || word == "penalty") return {.kind = word};
  const std::string option = "--contacts";
  if (const std::vector<std::string> parts = split(word, ':'); parts.size() == 2 && parts[0] == "penalty") {
    return {.kind = parts[0], .stiffness = real_number(option, parts[1], false)};
  }
  const std::vector<std::string> parts = split(word, 'x');
  if (parts.size() != 2 || word.find_first_not_of("0123456789x") != std::string::npos) {
    throw UsageError(
        fmt::format("{}: '{}' is no choice of contacts; expected impulse, penalty, iterations x substeps of "
                    "impulse contacts (12x4), or penalty with its stiffness in N/m (penalty:1e6)",
                    option, word));
  }
  return {"impulse", static_cast<int>(whole_number(option, parts[0], 1, 10000)),
          static_cast<int>(whole_number(option, parts[1], 1, 10000))};
}

std::vector<cost::ContactChoice> contacts_of(const std::string& text) {
  std::vector<cost::ContactChoice> list;
  for (const std::string& word : split(text, ',')) list.push_back(contact_of(word));
  return list;
}

/// In the order asked for: 0 sums every pair.
std::vector<double> openings_of(const std::string& text) {
  std::vector<double> angles;
  for (const std::string& word : split(text, ',')) {
    const double angle = word == "0" ? 0 : real_number("--openings", word, false);
    if (angle > 1) throw UsageError(fmt::format("--openings: {:g} rad is beyond 1, the largest opening angle", angle));
    angles.push_back(angle);
  }
  return angles;
}

/// Steps that do not fill the duration have no end to compare.
void check_steps(const std::vector<double>& steps, double duration) {
  for (const double step : steps) {
    if (cost::steps_in(duration, step) > 0) continue;
    throw UsageError(fmt::format("--steps: {} s does not divide run.duration = {} s into whole steps", step, duration));
  }
}

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const IntegratorDescription& row : integrators()) names.push_back(row.name);
  return names;
}

cost::Axes axes_of(const Arguments& arguments, const Scene& scene) {
  cost::Axes axes;
  if (arguments.integrators) {
    axes.integrators = words_of("--integrators", *arguments.integrators, "integrator", integrator_names());
  }
  if (arguments.axis_steps) axes.steps = numbers_of("--steps", *arguments.axis_steps);
  check_steps(axes.steps, scene.run.duration);
  if (arguments.tolerances) axes.tolerances = numbers_of("--tolerances", *arguments.tolerances);
  if (arguments.precisions) {
    for (const std::string& word :
         words_of("--precisions", *arguments.precisions, "precision", {"single", "double", "extended"})) {
      axes.precisions.push_back(word == "single"   ? Precision::single_
                                : word == "double" ? Precision::double_
                                                   : Precision::extended);
    }
  } else if (arguments.precision) {
    throw UsageError("--precision: cost compares precisions; expected --precisions, for example --precisions double");
  }
  if (arguments.rotations) {
    if (!cost::turns(scene)) throw UsageError("--rotations: no body of this scene has an orientation that changes");
    std::vector<std::string> names;
    for (const NamedDescription& rule : rotations()) names.push_back(rule.name);
    axes.rotations = words_of("--rotations", *arguments.rotations, "rotation", names);
  }
  if (arguments.openings) {
    if (!cost::may_use_tree(scene)) {
      throw UsageError("--openings: mutual_gravity acts on fewer than 256 bodies of this scene, which use no tree");
    }
    axes.openings = openings_of(*arguments.openings);
  }
  if (arguments.axis_contacts) {
    if (scene.contact.kind.empty()) throw UsageError("--contacts: this scene has no contacts");
    axes.contacts = contacts_of(*arguments.axis_contacts);
  }
  return axes;
}

/// "position", "orientation.end", "velocity.rms".
cost::Measure measure_of(const std::string& text) {
  const std::vector<std::string> parts = split(text, '.');
  std::vector<std::string> names;
  for (std::size_t q = 0; q < cost::quantity_count; ++q) names.emplace_back(name(static_cast<cost::Quantity>(q)));
  const auto place = std::find(names.begin(), names.end(), parts.front());
  if (place == names.end()) throw UsageError("--error: " + no_such("quantity", parts.front(), names));
  cost::Measure measure{static_cast<cost::Quantity>(place - names.begin()), "maximum"};
  if (parts.size() == 1) return measure;
  const std::vector<std::string> kinds{"maximum", "end", "rms"};
  if (parts.size() > 2 || std::find(kinds.begin(), kinds.end(), parts[1]) == kinds.end()) {
    throw UsageError("--error: " + no_such("kind", text.substr(parts.front().size() + 1), kinds));
  }
  measure.which = parts[1];
  return measure;
}

/// "2ms", "500us", "1.5s", or seconds.
double duration_of(const std::string& option, const std::string& text) {
  constexpr std::pair<const char*, double> units[] = {{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1}};
  for (const auto& [unit, seconds] : units) {
    if (!text.ends_with(unit)) continue;
    return seconds * real_number(option, text.substr(0, text.size() - std::string(unit).size()), false);
  }
  return real_number(option, text, false);
}

/// Copies are runs of ensembles, beyond a horizon: what is compared inside it is the scene as it is.
void take_ensemble(const Arguments& arguments, cost::Request& request) {
  if (arguments.command == "order") {
    if (arguments.copies) throw UsageError("--copies: order measures one copy of the scene");
    return;
  }
  if (arguments.copies && request.options.copies < cost::fewest_copies) {
    throw UsageError(fmt::format("--copies: statistics need an ensemble of at least {} runs", cost::fewest_copies));
  }
  if (arguments.perturb && !(request.options.perturb > 0)) {
    throw UsageError("--perturb: copies that start alike are no ensemble; expected a number above 0");
  }
  if (arguments.copies) request.copies = request.options.copies;
  if (arguments.perturb) request.perturb = request.options.perturb;
  request.options.copies = 1;
  request.options.perturb = 0;
}

}  // namespace

cost::Request cost_request(const Arguments& arguments, const Scene& scene) {
  cost::Request request;
  request.options = run_options(arguments);
  take_ensemble(arguments, request);
  check_memory(scene, request.options);
  if (!(scene.run.duration > 0)) throw UsageError("run.duration is 0: there is no error to measure");
  if (body_count(scene) == 0) throw UsageError("the scene has no bodies: there is no error to measure");
  request.axes = axes_of(arguments, scene);
  if (arguments.error) request.measure = measure_of(*arguments.error);
  if (arguments.seconds) request.seconds = real_number("--seconds", *arguments.seconds, false);
  if (arguments.tolerance) request.tolerance = real_number("--tolerance", *arguments.tolerance, false);
  if (arguments.budget) request.budget = duration_of("--budget", *arguments.budget);
  if (arguments.tolerance && arguments.budget) {
    throw UsageError("--tolerance and --budget exclude each other: one asks for accuracy, the other for speed");
  }
  if (arguments.reference) {
    request.reference =
        words_of("--reference", *arguments.reference, "reference", {"best", "numerical", "runs"}).front();
  }
  return request;
}

}  // namespace ballpark::command
