#include "perf/cost/subject.h"
#include "perf/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ballpark::cost {

namespace {

using perf::seconds_now;

Options options_for(Options options, const Setting& setting) {
  options.precision = setting.precision;
  return options;
}

/// Settings of one formulation mean nothing to the other, but for the margin.
void set_contact(ContactSettings& contact, const ContactChoice& choice) {
  if (choice.kind.empty()) return;
  if (contact.kind != choice.kind) {
    const double margin = contact.margin;
    contact = {};
    contact.kind = choice.kind;
    contact.margin = margin;
  }
  if (choice.kind == "impulse") {
    contact.iterations = choice.iterations;
    contact.substeps = choice.substeps;
  } else {
    contact.stiffness = choice.stiffness;
  }
}

}  // namespace

Scene scene_with(const Scene& scene, const Setting& setting) {
  Scene changed = scene;
  changed.run.integrator = setting.integrator;
  changed.run.step = setting.step;
  changed.run.tolerance = setting.tolerance;
  if (setting.tolerance == 0) changed.run.absolute_tolerance = 0;
  changed.run.precision = setting.precision;
  if (!setting.rotation.empty()) changed.run.rotation = setting.rotation;
  set_contact(changed.contact, setting.contact);
  for (Effect& effect : changed.effects) {
    if (setting.opening_angle < 0 || effect.kind != "mutual_gravity") continue;
    effect.parameters["opening_angle"] = setting.opening_angle;
  }
  return changed;
}

Setting setting_of(const Scene& scene) {
  Setting own{scene.run.integrator, scene.run.step, scene.run.tolerance, scene.run.precision};
  const ContactSettings& contact = scene.contact;
  if (contact.kind == "impulse") own.contact = {contact.kind, contact.iterations, contact.substeps};
  if (contact.kind == "penalty") own.contact = {.kind = contact.kind, .stiffness = contact.stiffness};
  if (turns(scene)) own.rotation = scene.run.rotation;
  if (!may_use_tree(scene)) return own;
  own.opening_angle = 0;
  for (const Effect& effect : scene.effects) {
    const auto angle = effect.parameters.find("opening_angle");
    if (effect.kind == "mutual_gravity" && angle != effect.parameters.end()) {
      own.opening_angle = std::max(own.opening_angle, std::get<double>(angle->second));
    }
  }
  return own;
}

bool may_use_tree(const Scene& scene) {
  constexpr std::size_t fewest = 256;  // GravityTree::fewest: below, every pair is summed anyway
  const auto attracts_all = [](const Effect& effect) { return effect.kind == "mutual_gravity"; };
  if (std::none_of(scene.effects.begin(), scene.effects.end(), attracts_all)) return false;
  std::size_t bodies = 0;
  const World world(scene);
  for (const GroupReport& group : world.explain().groups) {
    const auto attracts = [](const std::string& effect) { return effect == "mutual_gravity"; };
    if (std::any_of(group.effects.begin(), group.effects.end(), attracts)) bodies += group.bodies;
  }
  return bodies >= fewest;
}

Setting allowed(const Scene& scene, Setting setting) {
  if (!turns(scene)) return setting;
  if (setting.rotation.empty()) setting.rotation = scene.run.rotation;
  if (!check(scene_with(scene, setting)).empty()) setting.rotation = usual_rotation;
  return setting;
}

bool has_own_axes(const BodyGroup& group) {
  return std::any_of(group.inertia.begin(), group.inertia.end(),
                     [](const Vector3d& i) { return i.x() != i.y() || i.y() != i.z(); });
}

bool turns(const Scene& scene) {
  return std::any_of(scene.effects.begin(), scene.effects.end(), [](const Effect& e) { return e.kind == "pivot"; }) ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodyGroup& group) {
           return !group.orientation.empty() || (group.generate && group.generate->random_orientation) ||
                  has_own_axes(group);
         });
}

bool same_curve(const Setting& a, const Setting& b) {
  Setting paced = b;
  paced.step = a.step;
  paced.tolerance = a.tolerance;
  return a == paced && (a.tolerance > 0) == (b.tolerance > 0);
}

std::string opening_text(double angle) {
  return angle > 0 ? fmt::format("opening {:g}", angle) : "every pair";
}

std::string text(const Setting& setting) {
  std::string words = setting.integrator;
  words += setting.tolerance > 0 ? fmt::format(", tolerance {:.6g}", setting.tolerance)
                                 : fmt::format(", step {:.6g} s", setting.step);
  if (setting.precision == Precision::single_) words += ", single";
  if (setting.precision == Precision::extended) words += ", extended";
  if (!setting.rotation.empty() && setting.rotation != usual_rotation) words += ", rotation by " + setting.rotation;
  if (!setting.contact.kind.empty()) words += ", " + text(setting.contact);
  if (setting.opening_angle >= 0) words += ", " + opening_text(setting.opening_angle);
  return words;
}

std::string text(const ContactChoice& contact) {
  if (contact.kind == "penalty") return fmt::format("penalty {:.6g} N/m", contact.stiffness);
  return fmt::format("{} iterations x {}", contact.iterations, contact.substeps);
}

std::uint64_t steps_at_once(std::size_t bodies) {
  return std::clamp<std::uint64_t>(200'000 / std::max<std::size_t>(bodies, 1), 1, 20'000);
}

std::string time_text(double seconds) {
  constexpr std::pair<double, const char*> units[] = {{1, "s"}, {1e-3, "ms"}, {1e-6, "us"}};
  for (const auto& [size, name] : units) {
    if (seconds >= size) return fmt::format("{:.3g} {}", seconds / size, name);
  }
  return fmt::format("{:.3g} ns", 1e9 * seconds);
}

std::uint64_t steps_in(double duration, double step) {
  if (!(step > 0)) return 0;
  const double exact = duration / step, whole = std::round(exact);
  return whole >= 1 && std::abs(exact - whole) <= 1e-9 * whole ? static_cast<std::uint64_t>(whole) : 0;
}

Subject::Subject(const Scene& scene, const Setting& setting, const Options& options)
    : scene_(scene_with(scene, setting)),
      world_(scene_, options_for(options, setting)),
      begin_(world_.snapshot()),
      totals_(world_.totals()),
      steps_(steps_in(scene.run.duration, setting.step)) {}

double Subject::run() {
  world_.restore(begin_);
  const double before = seconds_now();
  steps_ > 0 ? world_.step(steps_) : world_.advance_to(scene_.run.duration);
  return seconds_now() - before;
}

bool Subject::follow(const Samples& samples, Track& track, const GoOn& go_on) {
  const std::uint64_t most = steps_at_once(world_.body_count());
  world_.restore(begin_);
  for (std::size_t k = 0; k < samples.times.size(); ++k) {
    const double t = samples.times[k];
    for (bool there = false; !there;) {
      const std::uint64_t before = world_.steps();
      there = world_.approach(t, scene_.run.duration, most);
      if (!go_on()) return false;
      if (!there && world_.steps() == before) return true;  // no step is small enough
    }
    bool reached = false;
    world_.look_ahead(t, [&] {
      reached = std::abs(world_.time() - t) <= 1e-9 * t;
      if (reached) track.look(world_, samples, k);
    });
    if (!reached) world_.advance_to(t);  // as far as it goes, and why no farther
  }
  return true;
}

bool Subject::find_events(const Samples& samples, Track& track, const GoOn& go_on) {
  if (samples.events.empty()) return true;
  std::vector<Watch> watches;
  track.events.clear();
  for (const scenes::BodyEvent& event : samples.events) track.events.push_back({event.name});
  for (std::size_t i = 0; i < samples.events.size(); ++i) {
    watches.push_back(scenes::watch_for(samples.events[i], world_, track.events[i]));
  }
  world_.restore(begin_);
  for (std::uint64_t before = 1; before != world_.steps();) {
    before = world_.steps();
    advance_watching(world_, scene_.run.duration, watches, steps_at_once(world_.body_count()));
    if (!go_on()) return false;
  }
  return true;
}

std::string Subject::trouble() const {
  const Status& status = world_.status();
  const auto& accepted = scene_.run.accept;
  const bool known = std::find(accepted.begin(), accepted.end(), name(status.code)) != accepted.end();
  return status.code == Status::Code::ok || known ? "" : status.sentence;
}

}  // namespace ballpark::cost
