#include "perf/cost/contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/exact.h"

namespace ballpark::cost {

namespace {

using Choices = std::vector<ContactChoice>;

ContactChoice impulse(int iterations, int substeps) {
  return {"impulse", iterations, substeps};
}

ContactChoice penalty(double stiffness) {
  return {.kind = "penalty", .stiffness = stiffness};
}

/// What hard contacts tell of the springs that may stand for them.
struct Impact {
  double mass = 0, radius = 0;  ///< of the heaviest body and of the smallest [kg], [m]
  double speed = 0;             ///< [m/s]
  bool fastest = true;          ///< along the path; else after a fall of half a radius
};

double largest(const std::vector<double>& rows) {
  return rows.empty() ? 0 : *std::max_element(rows.begin(), rows.end());
}

Impact impact_of(const Ground& ground) {
  Impact impact;
  for (const BodyGroup& group : ground.scene.bodies) {
    if (group.shape.empty()) continue;
    const double big = largest(group.radius), ball = 4 * 3.14159265358979323846 / 3 * big * big * big;
    impact.mass = std::max(impact.mass, group.mass.empty() ? largest(group.density) * ball : largest(group.mass));
    const double small = *std::min_element(group.radius.begin(), group.radius.end());
    impact.radius = impact.radius == 0 ? small : std::min(impact.radius, small);
  }
  double gravity = 0;
  for (const Effect& effect : ground.scene.effects) {
    if (effect.kind == "gravity") gravity += vector(effect, "acceleration").norm();
  }
  impact.speed = ground.reference.about.scale[static_cast<std::size_t>(Quantity::velocity)];
  const double fall = std::sqrt(gravity * impact.radius);
  impact.fastest = impact.speed >= fall;
  if (!impact.fastest) impact.speed = fall;
  return impact;
}

constexpr double usual_overlap = 0.01;  ///< of a radius
constexpr double softer = 0.01, stiffer = 100;

/// Of the spring that stops the impact within this overlap, to one digit: v = d sqrt(k / m).
double stiffness_for(const Impact& impact) {
  const double root = impact.speed / (usual_overlap * impact.radius), exact = impact.mass * root * root;
  if (!(exact > 0 && std::isfinite(exact))) return 0;
  const double digit = std::pow(10.0, std::floor(std::log10(exact)));
  return digit >= 1 ? digit * std::round(exact / digit) : std::round(exact / digit) / std::round(1 / digit);
}

/// Of a formulation: the scene's own, then more and less exact ones.
Choices usual(const Ground& ground, const std::string& kind) {
  const ContactSettings& own = ground.scene.contact;
  if (kind == "penalty") {
    if (own.kind == kind) return {penalty(own.stiffness)};
    const double stiffness = stiffness_for(impact_of(ground));
    return {penalty(stiffness), penalty(softer * stiffness), penalty(stiffer * stiffness)};
  }
  const ContactSettings& like = own.kind == kind ? own : ContactSettings{};
  const int n = like.iterations, s = like.substeps;
  if (own.kind != kind) return {impulse(n, s), impulse(n, 4 * s), impulse(3 * n, s)};
  return {impulse(n, s), impulse(std::max(1, n / 3), s), impulse(3 * n, s), impulse(n, 2 * s), impulse(n, 4 * s)};
}

/// Why the scene cannot have such contacts; "" if it can.
std::string refusal(const Scene& scene, const ContactChoice& choice) {
  constexpr double fine = 1e6;  // for boundaries that move
  const Setting setting{.integrator = "rk4", .step = scene.run.duration / fine, .contact = choice};
  const std::vector<Problem> problems = check(scene_with(scene, allowed(scene, setting)));
  if (problems.empty()) return "";
  const std::string &why = problems.front().message, prefix = choice.kind + ": ";
  return why.starts_with(prefix) ? why.substr(prefix.size()) : why;
}

void add_once(Choices& list, const ContactChoice& choice) {
  if (std::find(list.begin(), list.end(), choice) == list.end()) list.push_back(choice);
}

/// The own and the usual of the other formulation first: where time is short the rest is left out.
Choices all(const Ground& ground) {
  const std::string own = ground.scene.contact.kind, other = own == "impulse" ? "penalty" : "impulse";
  const Choices ours = usual(ground, own), theirs = usual(ground, other);
  Choices list{ours.front(), theirs.front()};
  for (const ContactChoice& choice : ours) add_once(list, choice);
  for (const ContactChoice& choice : theirs) add_once(list, choice);
  return list;
}

Choices with_numbers(const Ground& ground, const Choices& asked) {
  Choices list;
  for (const ContactChoice& choice : asked) {
    const bool complete = choice.iterations > 0 || choice.stiffness > 0;
    for (const ContactChoice& each : complete ? Choices{choice} : usual(ground, choice.kind)) add_once(list, each);
  }
  return list;
}

/// Which springs stand for hard contacts, and why these.
std::string about_springs(const Ground& ground) {
  const Impact impact = impact_of(ground);
  const double stiffness = stiffness_for(impact);
  return fmt::format(
      "Springs of {:g} N/m stop the heaviest body at {:.2g} m/s ({}) within about {:g} % of the smallest radius, of "
      "{:g} "
      "N/m within {:g} %, of {:g} N/m within {:g} %.",
      stiffness, impact.speed, impact.fastest ? "the fastest along the path" : "after a fall of half a radius",
      100 * usual_overlap, softer * stiffness, 100 * usual_overlap / std::sqrt(softer), stiffer * stiffness,
      100 * usual_overlap / std::sqrt(stiffer));
}

}  // namespace

bool same_equations(const Scene& scene, const ContactChoice& choice) {
  if (choice.kind.empty()) return true;
  return choice.kind == scene.contact.kind && (choice.kind != "penalty" || choice.stiffness == scene.contact.stiffness);
}

Choices contacts_to_try(const Ground& ground, const Choices& asked, Result& result) {
  const Scene& scene = ground.scene;
  if (scene.contact.kind.empty()) return {ContactChoice{}};
  Choices list = asked.empty() ? all(ground) : with_numbers(ground, asked);
  std::string said;
  std::erase_if(list, [&](const ContactChoice& choice) {
    const std::string why = refusal(scene, choice);
    if (!why.empty() && why != said) result.left_out.push_back(choice.kind + " contacts: " + why);
    if (!why.empty()) said = why;
    return !why.empty();
  });
  const ContactChoice own = setting_of(scene).contact;
  const auto other = [&](const ContactChoice& choice) { return !same_equations(scene, choice); };
  if (std::none_of(list.begin(), list.end(), other)) return list;
  result.remarks.push_back(
      fmt::format("Contacts other than the scene's own ({}) solve other equations: their errors hold the difference of "
                  "the models too, which no step takes away.",
                  own.kind == "penalty" ? text(own) : own.kind));
  const ContactChoice some_springs{.kind = "penalty"};
  const bool chosen_here = asked.empty() || std::find(asked.begin(), asked.end(), some_springs) != asked.end();
  const bool tried = std::any_of(list.begin(), list.end(), [](auto& choice) { return choice.kind == "penalty"; });
  if (own.kind != "penalty" && chosen_here && tried) result.remarks.push_back(about_springs(ground));
  return list;
}

}  // namespace ballpark::cost
