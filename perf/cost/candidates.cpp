// Which curves a sweep tries.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ballpark/catalogue.h"
#include "perf/cost/sweep.h"

namespace ballpark::cost {

namespace {

/// Those that serve most scenes first: where time is short the last ones are left out.
constexpr const char* ranking[] = {"rk4",
                                   "velocity_verlet",
                                   "dormand_prince8",
                                   "dormand_prince5",
                                   "semi_implicit_euler",
                                   "euler",
                                   "midpoint",
                                   "pefrl",
                                   "yoshida6",
                                   "ab4",
                                   "tsitouras5",
                                   "yoshida4",
                                   "abm4",
                                   "bogacki_shampine3"};

/// 1, 2, 5, 10, ... times `least`, while the step is not too small for time to move.
std::vector<double> steps_of(double duration, std::size_t least) {
  std::vector<double> steps;
  constexpr double most = 1e9;
  for (double power = static_cast<double>(least); power < most; power *= 10) {
    for (const double factor : {1.0, 2.0, 5.0}) steps.push_back(duration / (power * factor));
  }
  return steps;
}

std::vector<double> tolerances_of(Precision precision) {
  std::vector<double> list;
  const int last = precision == Precision::single_ ? 6 : 14;
  for (int exponent = 2; exponent <= last; ++exponent) list.push_back(std::pow(10.0, -exponent));
  return list;
}

const IntegratorDescription& description(const std::string& name) {
  return *std::find_if(integrators().begin(), integrators().end(), [&](auto& row) { return row.name == name; });
}

std::string label_of(const Setting& setting, bool adaptive, bool pair) {
  std::string label = setting.integrator;
  if (pair) label += adaptive ? ", adaptive" : ", fixed step";
  if (setting.precision == Precision::single_) label += ", single";
  if (setting.precision == Precision::extended) label += ", extended";
  if (!setting.rotation.empty() && setting.rotation != usual_rotation) label += ", " + setting.rotation;
  const ContactChoice& contact = setting.contact;
  if (contact.kind == "impulse") label += fmt::format(", {} x {}", contact.iterations, contact.substeps);
  if (contact.kind == "penalty") label += ", " + text(contact);
  if (setting.opening_angle >= 0) label += ", " + opening_text(setting.opening_angle);
  return label;
}

/// Single precision tells by a few integrators what it gives: rounding is the same for all.
constexpr std::size_t enough_in_single = 6;

/// Has it free bodies of three moments, whose angular momentum can be in their own axes?
bool may_keep_own_axes(const Scene& scene) {
  return std::none_of(scene.effects.begin(), scene.effects.end(), [](const Effect& e) { return e.kind == "pivot"; }) &&
         std::any_of(scene.bodies.begin(), scene.bodies.end(), has_own_axes);
}

/// How bodies turn: as the scene has it, then all other ways.
std::vector<std::string> rotations_of(const Scene& scene, const Axes& axes) {
  if (!turns(scene)) return {""};
  if (!axes.rotations.empty()) return axes.rotations;
  std::vector<std::string> names{scene.run.rotation};
  if (scene.run.compensated) return names;  // goes with the usual one alone
  for (const NamedDescription& rule : rotations()) {
    if (rule.name != scene.run.rotation && (rule.name != "body" || may_keep_own_axes(scene)))
      names.push_back(rule.name);
  }
  return names;
}

/// A few integrators tell what another way to turn gives; not every one takes it.
constexpr const char* enough_to_turn[] = {"rk4",   "velocity_verlet", "dormand_prince8", "dormand_prince5",
                                          "euler", "pefrl",           "yoshida6"};

/// Opening angles of the tree, the scene's own first. A few integrators tell what another one gives.
std::vector<double> openings_of(const Scene& scene, const Axes& axes) {
  const double own = setting_of(scene).opening_angle;
  if (own < 0) return {own};
  if (!axes.openings.empty()) return axes.openings;
  std::vector<double> list{own};
  for (const double angle : {0.5, 0.0, 0.7, 0.3, 1.0}) {
    if (angle != own) list.push_back(angle);
  }
  return list;
}
bool opens(const std::string& integrator) {
  return integrator == "velocity_verlet" || integrator == "rk4" || integrator == "dormand_prince8";
}

/// Impulse contacts are of first order whatever moves the bodies between them: a few integrators tell all.
constexpr const char* enough_for_impulse[] = {"semi_implicit_euler", "velocity_verlet", "rk4", "euler"};

/// Of penalty contacts in place of the scene's own: with fixed steps and steps that shorten where bodies touch.
constexpr const char* enough_for_penalty[] = {"velocity_verlet", "rk4", "dormand_prince5"};

/// For scenes whose stiffness limits the steps of explicit methods. (Others cost them several evaluations a step.)
constexpr const char* for_stiffness[] = {"backward_euler", "implicit_midpoint"};

/// Is a hundredth of its duration too long a step for rk4?
bool is_stiff(const Scene& scene) {
  const Scene coarse = scene_with(scene, allowed(scene, {.integrator = "rk4", .step = scene.run.duration / 100}));
  return check(coarse).empty() && World(coarse).status().code == Status::Code::stability;
}

std::vector<std::string> ranked_integrators(const Scene& scene, const std::string& contact) {
  std::vector<std::string> names{scene.run.integrator};
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  if (contact == "impulse") {
    for (const char* name : enough_for_impulse) add(name);
    return names;
  }
  if (contact != scene.contact.kind) {
    for (const char* name : enough_for_penalty) add(name);
    return names;
  }
  if (is_stiff(scene)) {
    for (const char* name : for_stiffness) add(name);
  }
  for (const char* name : ranking) add(name);
  for (const IntegratorDescription& row : integrators()) add(row.name);
  return names;
}

/// The setting at every pace asked for, or at all that may be tried, from coarse to fine.
std::vector<Setting> paced(const Scene& scene, const Axes& axes, std::size_t sample_count, Setting setting,
                           bool adaptive) {
  const auto chosen = adaptive ? axes.tolerances : axes.steps;
  std::vector<Setting> list;
  for (const double pace : !chosen.empty() ? chosen
                           : adaptive      ? tolerances_of(setting.precision)
                                           : steps_of(scene.run.duration, sample_count)) {
    (adaptive ? setting.tolerance : setting.step) = pace;
    list.push_back(setting);
  }
  return list;
}

/// Leaves out steps beyond the stability limit of two bodies that press each other: they need not be run to be known.
class StableSteps {
 public:
  explicit StableSteps(const Scene& scene) : scene_(scene) {}

  void keep(std::vector<Setting>& settings, const std::string& label) {
    const Setting& finest = settings.back();
    if (finest.contact.kind != "penalty" || finest.tolerance > 0) return;
    const double limit = World(scene_with(scene_, finest)).explain().contact.largest_step;
    if (limit > 0 && std::erase_if(settings, [&](const Setting& each) { return each.step > limit; }) > 0) {
      limits_.emplace_back(limit, label);
    }
  }
  std::string left_out() const {
    if (limits_.empty()) return "";
    const auto [least, most] = std::minmax_element(limits_.begin(), limits_.end());
    std::string words =
        fmt::format("steps too long to be stable where two bodies press each other: above {:.2g} s of {}", least->first,
                    least->second);
    if (limits_.size() > 1) words += fmt::format(" to {:.2g} s of {}", most->first, most->second);
    return words;
  }

 private:
  const Scene& scene_;
  std::vector<std::pair<double, std::string>> limits_;  // and whose
};

}  // namespace

std::vector<Candidate> candidates(const Scene& scene, const Axes& axes, std::size_t sample_count,
                                  std::vector<std::string>& refused) {
  std::vector<Candidate> list;
  const auto precisions =
      axes.precisions.empty() ? std::vector{Precision::double_, Precision::single_} : axes.precisions;
  const auto contacts = axes.contacts.empty() ? std::vector{setting_of(scene).contact} : axes.contacts;
  const std::string& main_kind = contacts.front().kind;
  std::map<std::string, std::vector<std::string>> names_for;  // kinds of contacts
  for (const ContactChoice& contact : contacts) {
    if (names_for.count(contact.kind) > 0) continue;
    names_for[contact.kind] = axes.integrators.empty() ? ranked_integrators(scene, contact.kind) : axes.integrators;
  }
  const auto turnings = rotations_of(scene, axes);
  const auto openings = openings_of(scene, axes);
  std::map<std::string, std::string> reasons;  // and whom they refuse
  StableSteps stable(scene);
  const auto add = [&](const Setting& setting, bool adaptive) {
    const IntegratorDescription& row = description(setting.integrator);
    Candidate candidate;
    candidate.curve = {
        label_of(setting, adaptive, row.adaptive), row.name, row.family, row.order, setting.precision, {}};
    candidate.settings = paced(scene, axes, sample_count, setting, adaptive);
    const std::vector<Problem> problems = check(scene_with(scene, candidate.settings.front()));
    std::erase_if(candidate.settings, [&](const Setting& each) { return !check(scene_with(scene, each)).empty(); });
    if (!candidate.settings.empty()) {
      if (axes.steps.empty()) stable.keep(candidate.settings, candidate.curve.label);
      if (!candidate.settings.empty()) list.push_back(std::move(candidate));
      return;
    }
    const std::string why = problems.front().message;
    const auto alike = [&](const ContactChoice& contact) { return contact.kind == setting.contact.kind; };
    const bool first_contact = *std::find_if(contacts.begin(), contacts.end(), alike) == setting.contact;
    if (setting.precision != precisions.front() || setting.rotation != turnings.front() || !first_contact) return;
    if (setting.opening_angle != openings.front()) return;
    std::string& names_so_far = reasons[why.starts_with(row.name) ? why.substr(row.name.size() + 1) : why];
    Setting bare = setting;
    bare.contact = {}, bare.opening_angle = -1;
    names_so_far += (names_so_far.empty() ? "" : ", ") + label_of(bare, adaptive, row.adaptive);
    if (setting.contact.kind != main_kind) names_so_far += fmt::format(" (under {} contacts)", setting.contact.kind);
  };
  const auto add_paces = [&](const Setting& setting) {
    if (axes.tolerances.empty() || !axes.steps.empty()) add(setting, false);
    const bool adaptive = description(setting.integrator).adaptive;
    if (adaptive && (axes.steps.empty() || !axes.tolerances.empty())) add(setting, true);
  };
  const std::vector<std::string> some(std::begin(enough_to_turn), std::end(enough_to_turn));
  for (const Precision precision : precisions) {
    const bool chosen = !axes.integrators.empty() || !axes.precisions.empty() || precision == Precision::double_;
    for (const ContactChoice& contact : contacts) {
      if (!chosen && contact.kind != main_kind) continue;
      const std::vector<std::string>& names = names_for[contact.kind];
      for (std::size_t i = 0; i < (chosen ? names.size() : std::min(names.size(), enough_in_single)); ++i) {
        for (const double angle : chosen ? openings : std::vector{openings.front()}) {
          const bool told = angle == openings.front() || !axes.integrators.empty() || opens(names[i]);
          if (told) add_paces({names[i], 0, 0, precision, contact, turnings.front(), angle});
        }
      }
    }
    for (std::size_t r = 1; r < turnings.size() && chosen; ++r) {
      const auto& few = axes.integrators.empty() ? some : axes.integrators;
      for (const std::string& name : few) {
        add_paces({name, 0, 0, precision, contacts.front(), turnings[r], openings.front()});
      }
    }
  }
  for (const auto& [why, whom] : reasons) refused.push_back(whom + ": " + why);
  if (!stable.left_out().empty()) refused.push_back(stable.left_out());
  if (axes.integrators.empty() && names_for.count("impulse") > 0) {
    refused.push_back("more integrators: impulse contacts are of first order under all of them (--integrators)");
  }
  for (const auto& [kind, names] : names_for) {
    if (kind == main_kind || !axes.integrators.empty() || !axes.precisions.empty()) continue;
    refused.push_back(
        fmt::format("single precision, and more integrators, under {} contacts (--contacts {})", kind, kind));
  }
  if (axes.integrators.empty() && axes.precisions.empty() && names_for[main_kind].size() > enough_in_single) {
    refused.push_back("single precision of more than six integrators (--precisions single,double)");
  }
  if (scene.run.compensated && turns(scene)) {
    refused.push_back("rotation other than by " + turnings.front() + ": run.compensated goes with renormalise alone");
  }
  if (axes.integrators.empty() && axes.openings.empty() && openings.size() > 1) {
    refused.push_back("other opening angles than the scene's, of more than three integrators (--openings)");
  }
  if (axes.integrators.empty() && axes.rotations.empty() && turnings.size() > 1) {
    refused.push_back("rotation other than by " + turnings.front() + ", of more than seven integrators (--rotations)");
  }
  return list;
}

}  // namespace ballpark::cost
