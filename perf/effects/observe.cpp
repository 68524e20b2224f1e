#include "perf/effects/observe.h"

#include <fmt/format.h>

#include <cmath>

#include "scenarios/files/quantity.h"

namespace ballpark::cost {

namespace {

using scenes::Expectation;
using scenes::Quantity;
using scenes::SceneFile;

/// Does a body of the world carry what is asked for? What no effect reads may be gone with one.
bool carried(const std::string& quantity, const World& world) {
  const Quantity asked(quantity);
  return asked.reads_report() || asked.state_problem(world).empty();
}

bool is_of_event(const std::string& quantity, const std::string& event) {
  return quantity.starts_with("events." + event + ".");
}

/// The file as the world can answer it.
SceneFile answerable(const SceneFile& file, const Scene& scene, const World& world) {
  SceneFile asked = file;
  asked.scene = scene;
  asked.outputs.clear();
  asked.events.clear();
  for (const scenes::EventRequest& event : file.events) {
    if (carried(event.quantity, world)) {
      asked.events.push_back(event);
    } else {
      std::erase_if(asked.expectations, [&](const Expectation& e) { return is_of_event(e.quantity, event.name); });
    }
  }
  std::erase_if(asked.expectations, [&](const Expectation& e) { return !carried(e.quantity, world); });
  return asked;
}

bool same(const Expectation& a, const Expectation& b) {
  return a.quantity == b.quantity && a.at == b.at && a.minimum == b.minimum && a.maximum == b.maximum &&
         a.value == b.value && a.tolerance == b.tolerance;
}

/// False if it was stopped.
bool see_expectations(const SceneFile& file, const SceneFile& asked, const Options& options, const GoOn& go_on,
                      std::vector<Observation>& list) {
  if (file.expectations.empty()) return true;
  scenes::RunHooks hooks;
  hooks.progress = [&](double) { return go_on(); };
  const scenes::RunReport report =
      asked.expectations.empty() ? scenes::RunReport{} : scenes::run(asked, options, hooks);
  for (const Expectation& expectation : file.expectations) {
    Observation seen{.name = expectation.quantity, .unit = "", .missed = true};
    if (expectation.at) seen.name += fmt::format(" at {:g} s", *expectation.at);
    for (const scenes::Verdict& verdict : report.verdicts) {
      if (!same(verdict.expectation, expectation)) continue;
      seen.value = Vector3d(verdict.measured, 0, 0);
      seen.there = std::isfinite(verdict.measured);
      seen.missed = !verdict.met;
    }
    list.push_back(seen);
  }
  return !report.interrupted;
}

/// When and where a body was at the first of an event.
struct First {
  scenes::EventTimes times;
  Vector3d place = Vector3d::Zero();
};

/// False if it was stopped.
bool see_events(const SceneFile& file, const SceneFile& asked, World& world, const GoOn& go_on,
                std::vector<Observation>& list) {
  const std::vector<scenes::BodyEvent> events = scenes::events_of(asked, world);
  std::vector<First> firsts(events.size());
  std::vector<Watch> watches;
  for (std::size_t i = 0; i < events.size(); ++i) {
    firsts[i].times.name = events[i].name;
    Watch watch = scenes::watch_for(events[i], world, firsts[i].times);
    const auto note = [&world, &first = firsts[i], body = events[i].body, seen = watch.seen](double time, bool rising) {
      const bool before = first.times.count > 0;
      seen(time, rising);
      if (!before && first.times.count > 0) first.place = world.body(body).position;
    };
    watch.seen = note;
    watches.push_back(watch);
  }
  for (std::uint64_t before = 1; !watches.empty() && before != world.steps();) {
    before = world.steps();
    advance_watching(world, asked.scene.run.duration, watches, steps_at_once(world.body_count()));
    if (!go_on()) return false;
  }
  for (const scenes::EventRequest& request : file.events) {
    Observation time{.name = request.name, .unit = "s"}, place{.name = "place of " + request.name, .unit = "m"};
    for (const First& first : firsts) {
      if (first.times.name != request.name || first.times.count == 0) continue;
      time.value = Vector3d(first.times.times.front(), 0, 0);
      place.value = first.place;
      time.there = place.there = true;
    }
    list.push_back(time);
    list.push_back(place);
  }
  return true;
}

}  // namespace

std::optional<std::vector<Observation>> observe(const SceneFile& file, const Scene& scene, const Options& options,
                                                const GoOn& go_on) {
  std::vector<Observation> list;
  World world(scene, options);
  const SceneFile asked = answerable(file, scene, world);
  if (!see_expectations(file, asked, options, go_on, list)) return std::nullopt;
  if (!file.events.empty() && !see_events(file, asked, world, go_on, list)) return std::nullopt;
  return list;
}

double apart(const Observation& a, const Observation& b) {
  return a.there && b.there ? (a.value - b.value).norm() : std::numeric_limits<double>::infinity();
}

}  // namespace ballpark::cost
